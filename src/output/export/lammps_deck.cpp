// SPDX-License-Identifier: MIT
#include "output/export/lammps_deck.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "output/export/lammps_types.hpp"

namespace hackle {
namespace {

constexpr std::size_t max_groups = 30;
constexpr double never = 10.0;  // a stretch at which nothing breaks

// Nodes that are pulled alike.
using PulledNodes = std::map<std::pair<double, double>, std::vector<std::size_t>>;

PulledNodes pulled_nodes(const LammpsScene& scene) {
  PulledNodes nodes;
  for (std::size_t node = 0; node < scene.pull.size(); ++node)
    if (scene.removed[node] == 0 && scene.pull[node] != Vec2(0.0, 0.0))
      nodes[{scene.pull[node].x(), scene.pull[node].y()}].push_back(node);
  if (nodes.size() > max_groups)
    throw Error(ErrorKind::refused,
                fmt::format("export: LAMMPS's peri/pmb has no loads of more than {} sizes and "
                            "directions, this plate has {}",
                            max_groups, nodes.size()),
                "loads on straight edges can be exported");
  return nodes;
}

// Returns "1:100 401:801:100": runs of atoms at equal distances.
std::string runs_of(const std::vector<std::size_t>& nodes) {
  std::string text;
  for (std::size_t first = 0; first < nodes.size();) {
    std::size_t last = first;
    const std::size_t stride =
        first + 1 < nodes.size() ? nodes[first + 1] - nodes[first] : std::size_t{1};
    while (last + 1 < nodes.size() && nodes[last + 1] - nodes[last] == stride) ++last;
    fmt::format_to(std::back_inserter(text), " {}:{}:{}", nodes[first] + 1, nodes[last] + 1,
                   stride);
    first = last + 1;
  }
  return text;
}

std::string loads_text(const LammpsScene& scene) {
  std::string text;
  int number = 0;
  for (const auto& [pull, nodes] : pulled_nodes(scene)) {
    ++number;
    // addforce acts on the force density, which is divided by the density, 1.
    fmt::format_to(std::back_inserter(text),
                   "group load{0} id{1}\nfix pull{0} load{0} addforce {2:.17g} {3:.17g} 0\n",
                   number, runs_of(nodes), pull.first, pull.second);
  }
  return text;
}

// Without a ramp the spacing that LAMMPS is told, which is the width of the ramp and the reach of
// its contact forces, is so small that it has no effect, and the horizon lies between the last
// neighbour that counts and the first that does not.
double told_spacing(const LammpsScene& scene) {
  return scene.is_ramped ? 1.0 : 1e-6;
}
double told_horizon(const LammpsScene& scene) {
  return scene.is_ramped ? scene.m : std::sqrt(std::floor(scene.m * scene.m + 1e-6) + 0.5);
}

std::string pair_text(const LammpsScene& scene, const LammpsTypes& types) {
  constexpr double no_horizon = 0.1;  // no two nodes are so near
  const auto out = [](std::string& text) { return std::back_inserter(text); };
  std::string text = fmt::format("pair_coeff * * {:.17g} {:.17g} {:.17g} {:.17g}\n", scene.c,
                                 told_horizon(scene), scene.s00, scene.alpha);
  for (std::size_t type = 1; type <= types.strong.size(); ++type)
    if (types.strong[type - 1] != 0)
      for (const auto& pair : {fmt::format("{0} {0}*", type), fmt::format("1*{0} {0}", type)})
        fmt::format_to(out(text), "pair_coeff {} {:.17g} {:.17g} {} {:.17g}\n", pair, scene.c,
                       told_horizon(scene), never, scene.alpha);
  for (const auto& [one, other] : types.apart)
    fmt::format_to(out(text), "pair_coeff {} {} {:.17g} {} {:.17g} {:.17g}\n", one, other, scene.c,
                   no_horizon, scene.s00, scene.alpha);
  return text;
}

std::string dump_text(const LammpsPlan& plan) {
  if (plan.every == 0) return {};
  return fmt::format(
      "compute damage all damage/atom\n"
      "dump nodes all custom {} nodes.dump id x y c_damage\n"
      "dump_modify nodes sort id format float %.17g\n",
      plan.every);
}

std::size_t count_of(const LammpsScene& scene) {
  return static_cast<std::size_t>(std::ranges::count(scene.removed, 0));
}

}  // namespace

// The box is shrink-wrapped, so no atom is the periodic image of another.
std::string lammps_data(const LammpsScene& scene) {
  const LammpsTypes types = lammps_types(scene);
  const Grid& grid = scene.grid;
  std::string text = fmt::format(
      "nodes of a plate\n\n{} atoms\n{} atom types\n{} {} xlo xhi\n{} {} ylo yhi\n-0.5 0.5 zlo "
      "zhi\n\nAtoms # peri\n\n",
      count_of(scene), types.strong.size(), -0.5 * grid.nx, 0.5 * grid.nx, -0.5 * grid.ny,
      0.5 * grid.ny);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const std::size_t node = grid.index(i, j);
      if (scene.removed[node] != 0) continue;
      const Vec2 place = grid.from_centre(i, j);
      const int volume = 1, density = 1;
      fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {} 0\n", node + 1,
                     types.of_node[node], volume, density, place.x(), place.y());
    }
  return text;
}

std::string lammps_deck(const LammpsScene& scene, const LammpsPlan& plan,
                        const std::string& data_name) {
  return fmt::format(
      R"({heading}units lj
dimension 2
boundary s s p
atom_style peri
atom_modify map array sort 0 0
lattice sq {density:.17g}
read_data {data}
pair_style peri/pmb
{pairs}{neighbours}{loads}fix move all nve
{dump}thermo {thermo}
timestep 1
run {steps}
)",
      fmt::arg("heading", plan.heading), fmt::arg("density", std::pow(told_spacing(scene), -2)),
      fmt::arg("data", data_name), fmt::arg("pairs", pair_text(scene, lammps_types(scene))),
      fmt::arg("neighbours", plan.is_timed
                                 ? "neighbor 0.1 bin\nneigh_modify every 1000000 delay 1000000 "
                                   "check no\n"
                                 : "neighbor 0.5 bin\n"),
      fmt::arg("loads", loads_text(scene)), fmt::arg("dump", dump_text(plan)),
      fmt::arg("thermo", std::max<std::int64_t>(plan.steps, 1)), fmt::arg("steps", plan.steps));
}

}  // namespace hackle
