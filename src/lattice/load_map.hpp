// SPDX-License-Identifier: MIT
// Maps the loads of a scene to nodes, with their values at amplitude 1.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lattice/carve.hpp"
#include "lattice/lattice.hpp"
#include "scene/loads.hpp"

namespace hackle {

// A node with a force.
struct LoadedNode {
  int i = 0;
  int j = 0;
  Vec2 acceleration{0, 0};  // m/s2
  double inertia = 1.0;     // its density over Lattice::rho
};

// A node whose motion is prescribed, along x, y or both.
struct HeldNode {
  int i = 0;
  int j = 0;
  Vec2 value{0, 0};  // m or m/s
  bool along_x = true;
  bool along_y = true;
};

// A quantity of nodes that is a function of place and time: of node k, the field at places[k] over
// divisors[k]. Empty for a quantity that does not vary in time, or by its amplitude alone.
template <class T>
struct Course {
  FieldOfPlace<T> field;
  std::string who;           // in messages: "traction"
  std::vector<Vec2> places;  // m
  std::vector<double> divisors;

  bool empty() const { return places.empty(); }
};

// Returns the values of all nodes at a time, s. Throws what the function throws, and Error
// (refused) for a value that is not finite.
std::vector<Vec2> values_at(const Course<Vec2>& course, double t);
std::vector<double> values_at(const Course<double>& course, double t);

// A force on nodes, each listed once, ordered by index; void nodes are left out. Where there is a
// course, the nodes have its values at t = 0.
struct SpreadForce {
  std::vector<LoadedNode> nodes;
  Amplitude amplitude;
  Course<Vec2> course;
};
struct SpreadSupport {
  std::vector<HeldNode> nodes;
  Support::Kind kind = Support::Kind::displacement;
  Amplitude amplitude;
  Course<Vec2> course;
};

// Thermal strain of nodes: alphaT of their material times the change of temperature.
struct SpreadHeat {
  NodeRange range;             // encloses the region
  std::vector<double> strain;  // by NodeRange::index; 0 outside the region
  Amplitude amplitude;
  Course<double> course;          // of the strain
  std::vector<std::size_t> at{};  // of the nodes of the course, in `strain`
};

// Returns tractions, pressures and body forces of the plate, in that order. Throws what functions
// of place throw, and Error (refused) if they give values that are not finite or a load finds no
// node to act on.
std::vector<SpreadForce> spread_forces(const Plate& plate, const Lattice& lattice);
std::vector<SpreadSupport> spread_supports(const Plate& plate, const Lattice& lattice);
// Returns the temperature changes, likewise.
std::vector<SpreadHeat> spread_heat(const Plate& plate, const Lattice& lattice);

// Returns the sum of two lists. In all three each node occurs once, ordered by index.
std::vector<LoadedNode> sum_of(std::span<const LoadedNode> one, std::span<const LoadedNode> other,
                               const Grid& grid);

}  // namespace hackle
