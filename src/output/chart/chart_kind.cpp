// SPDX-License-Identifier: MIT
#include "output/chart/chart_kind.hpp"

#include <algorithm>
#include <array>

namespace hackle {
namespace {

using Names = std::string_view;
constexpr auto energies = std::to_array<Names>(
    {"external", "kinetic", "strain", "broken", "damped", "released", "contact"});
constexpr auto places = std::to_array<Names>({"tip.x", "tip.y"});
constexpr auto speeds = std::to_array<Names>({"tip.speed"});
constexpr auto lengths = std::to_array<Names>({"crack.length"});
constexpr auto counts = std::to_array<Names>({"fragments"});

constexpr std::array kinds{
    ChartKind{"energy", "energy", energies, "Entries of the ledger of energy."},
    ChartKind{"tip", "place of the tip", places, "Place of the foremost tip of a crack."},
    ChartKind{"speed", "speed of the tip", speeds,
              "Speed of the tip, against that of Rayleigh waves, c_R."},
    ChartKind{"length", "new crack length", lengths, "Length of new cracks."},
    ChartKind{"fragments", "fragments", counts, "Number of fragments."},
    ChartKind{"load",
              "load",
              {},
              "Force of every support or body on the plate against its way, along the axis with "
              "the larger force; the table needs NAME.fx and NAME.ux, or .fy and .uy."},
    ChartKind{"histogram", "nodes", {}, "How many nodes have which value of a field."},
};

}  // namespace

std::span<const ChartKind> chart_kinds() {
  return kinds;
}

const ChartKind* chart_kind(std::string_view name) {
  const auto found = std::ranges::find(kinds, name, &ChartKind::name);
  return found == kinds.end() ? nullptr : &*found;
}

}  // namespace hackle
