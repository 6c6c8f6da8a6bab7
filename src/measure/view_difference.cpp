// SPDX-License-Identifier: MIT
#include "measure/view_difference.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "measure/field.hpp"

namespace hackle {
namespace {

double as(Compared how, double value) {
  return how == Compared::in_double ? value : static_cast<double>(static_cast<float>(value));
}

double distance(const Vec2& one, const Vec2& other, Compared how) {
  return std::hypot(as(how, one.x()) - as(how, other.x()), as(how, one.y()) - as(how, other.y()));
}

// Calls of(i, j) for the difference at each node.
template <class Of>
FieldDifference over_nodes(const Grid& grid, std::string name, std::string unit, const Of& of) {
  FieldDifference found{std::move(name), std::move(unit)};
  double squares = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const double difference = of(i, j);
      squares += difference * difference;
      if (difference <= found.max) continue;
      found.max = difference;
      found.i = i;
      found.j = j;
    }
  found.l2 = std::sqrt(squares / static_cast<double>(grid.nodes()));
  return found;
}

FieldDifference of_velocity(const View& one, const View& other, Compared how) {
  const Grid& grid = one.lattice().grid;
  const std::vector<Vec2> left = one.velocities(), right = other.velocities();
  return over_nodes(grid, "velocity", "m/s", [&](int i, int j) {
    const std::size_t node = grid.index(i, j);
    return one.lattice().is_void(i, j) ? 0.0 : distance(left[node], right[node], how);
  });
}

FieldDifference of_damage(const View& one, const View& other) {
  const Grid& grid = one.lattice().grid;
  const Field left = damage(one), right = damage(other);
  return over_nodes(grid, "damage", "", [&](int i, int j) {
    const std::size_t node = grid.index(i, j);
    return std::abs(static_cast<double>(left.values[node]) - right.values[node]);
  });
}

FieldDifference of_bonds(const View& one, const View& other) {
  const Grid& grid = one.lattice().grid;
  const BondBits &left = one.state().bonds, &right = other.state().bonds;
  const int words = std::min(one.lattice().family.words(), other.lattice().family.words());
  return over_nodes(grid, "bonds", "", [&](int i, int j) {
    int count = 0;
    for (int word = 0; word < words; ++word)
      count += std::popcount(left.word(grid.layout().at(i, j), word) ^
                             right.word(grid.layout().at(i, j), word));
    return static_cast<double>(count);
  });
}

FieldDifference of_temperature(const View& one, const View& other, Compared how) {
  return over_nodes(one.lattice().grid, "temperature", "K", [&](int i, int j) {
    return std::abs(as(how, temperature_of(one, i, j)) - as(how, temperature_of(other, i, j)));
  });
}

// Of bodies of one kind; one that only one view has is as far away as its plate is wide.
double apart(const std::vector<Disc>& one, const std::vector<Disc>& other, const Grid& grid,
             Compared how) {
  if (one.size() != other.size()) return grid.nx * grid.dx;
  double max = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k)
    max = std::max(max, distance(grid.dx * one[k].centre, grid.dx * other[k].centre, how));
  return max;
}

FieldDifference of_bodies(const View& one, const View& other, Compared how) {
  const Grid& grid = one.lattice().grid;
  const State &left = one.state(), &right = other.state();
  const double max = std::max({apart(left.discs, right.discs, grid, how),
                               apart(left.rollers, right.rollers, grid, how),
                               apart(left.platens, right.platens, grid, how)});
  return {"bodies", "m", max, -1, -1, max};
}

bool has_bodies(const View& view) {
  const State& state = view.state();
  return !state.discs.empty() || !state.rollers.empty() || !state.platens.empty();
}

}  // namespace

std::vector<FieldDifference> differences(const View& one, const View& other, Compared how) {
  std::vector<FieldDifference> list{
      over_nodes(one.lattice().grid, "displacement", "m",
                 [&](int i, int j) {
                   if (one.lattice().is_void(i, j)) return 0.0;
                   return distance(one.displacement(i, j), other.displacement(i, j), how);
                 }),
      of_velocity(one, other, how), of_damage(one, other), of_bonds(one, other)};
  if (!one.thermal_strain().empty() || !other.thermal_strain().empty())
    list.push_back(of_temperature(one, other, how));
  if (has_bodies(one) || has_bodies(other)) list.push_back(of_bodies(one, other, how));
  return list;
}

}  // namespace hackle
