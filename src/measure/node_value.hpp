// SPDX-License-Identifier: MIT
// What one node knows, by name, without a look at any other node's bonds: the quantities of gauges.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "solver/view.hpp"

namespace hackle {

struct NodeQuantity {
  std::string_view name;  // "uy"
  std::string_view unit;  // SI
  std::string_view sentence;
  double (*value)(const View& view, int i, int j) = nullptr;
};

inline constexpr auto node_quantity_names = std::to_array<std::string_view>(
    {"ux", "uy", "vx", "vy", "stress_xx", "stress_yy", "stress_xy", "stress_1", "stress_2",
     "von_mises", "strain_xx", "strain_yy", "strain_xy", "energy_density", "stretch", "damage",
     "temperature"});

// In the order of the names.
std::span<const NodeQuantity> node_quantities();

// Strain of the bonds of a node, symmetric: xy is half the engineering shear.
struct Strain {
  double xx = 0.0, yy = 0.0, xy = 0.0;
};

// Returns the strain that fits the intact bonds of a node best: of the gradient G of displacement
// that makes the sum of |h - G xi|^2 over them least, the symmetric part. It is exact for a uniform
// strain, at edges and beside cracks, too, and never sees across a crack. 0 where all intact bonds
// lie along one line.
Strain strain_of(const View& view, int i, int j);

}  // namespace hackle
