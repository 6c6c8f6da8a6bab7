// SPDX-License-Identifier: MIT
#include "store/exact_state.hpp"

#include <cmath>
#include <exception>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "store/recorded_bonds.hpp"
#include "store/snapshot_head.hpp"

namespace hackle {
namespace {

void read_exact_head(const Hdf5Reader& file, const std::string& name, Snapshot& snapshot) {
  const std::string text = file.text(name);
  try {
    read_head(nlohmann::json::parse(text), snapshot);
  } catch (const std::exception&) {  // its message may quote the file
    file.refuse(fmt::format("its {} is damaged", name));
  }
}

// A limit of stretch may be infinite, where bonds never break; nothing is no number.
template <class Real>
Values<Real> read_nodes(const Hdf5Reader& file, const std::string& name, const Grid& grid) {
  const std::vector<double> list = file.doubles(name, {grid.nodes()}, 1);
  Values<Real> values(grid.layout().size());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const double value = list[grid.index(i, j)];
      if (std::isnan(value)) file.refuse(fmt::format("its {} is damaged", name));
      values[static_cast<std::size_t>(grid.layout().at(i, j))] = static_cast<Real>(value);
    }
  return values;
}

void check_fits(const Hdf5Reader& file, const Snapshot& snapshot, const Lattice& lattice) {
  if (!fits(snapshot.state, lattice)) file.refuse("its exact state is not one of its plate");
  if (!names_only_its_own(snapshot, lattice.grid))
    file.refuse("its exact state names nodes or bonds that its plate has not");
}

}  // namespace

std::string exact_head(const Simulation& simulation) {
  return head_of(simulation.snapshot()).dump();
}

bool holds_exact_state(const Hdf5Reader& file, const std::string& group) {
  return file.holds(group + "/state");
}

Snapshot read_exact_state(const Hdf5Reader& file, const std::string& group,
                          const Lattice& lattice) {
  Snapshot snapshot;
  State& state = snapshot.state;
  state.layout = lattice.grid.layout();
  state.bonds = lattice.bonds;
  read_exact_head(file, group + "/state", snapshot);
  std::visit(
      [&](auto& motion) {
        for_each_array(
            [&](const char* name, auto& values) {
              using Real = typename std::remove_cvref_t<decltype(values)>::value_type;
              const std::string place = group + "/" + name;
              const bool optional = std::string_view(name) == "threshold";
              if (!optional || file.holds(place))
                values = read_nodes<Real>(file, place, lattice.grid);
            },
            motion);
      },
      state.motion);
  break_recorded(file, group, lattice, state.bonds);
  check_fits(file, snapshot, lattice);
  return snapshot;
}

}  // namespace hackle
