// SPDX-License-Identifier: MIT
// What changes while a scene is solved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lattice/lattice.hpp"

namespace hackle {

// An array over the nodes with a rim of `rim` ghost nodes on every side, so that a kernel may read
// the neighbours of an edge node. Ghosts are 0 and nobody is bonded to them.
struct Rimmed {
  int nx = 0;
  int ny = 0;
  int rim = 0;

  std::ptrdiff_t stride() const { return nx + 2 * rim; }
  std::ptrdiff_t at(int i, int j) const { return (j + rim) * stride() + i + rim; }
  std::size_t size() const {
    return static_cast<std::size_t>(stride()) * static_cast<std::size_t>(ny + 2 * rim);
  }
};

// Displacement, velocity and acceleration of every node at one time, and the bonds that hold. In
// lattice units: u/dx, v dt/dx, a dt^2/dx, so that v += a and u += v need no factors. u is rimmed;
// v and a are ordered as Grid::index says. u, v, a and bonds belong to the same time step * dt;
// after step() `a` is the acceleration of the bonds that still hold.
struct State {
  State() = default;
  explicit State(const Lattice& lattice);

  Rimmed layout;
  std::vector<double> ux, uy;  // rimmed
  std::vector<double> vx, vy;
  std::vector<double> ax, ay;
  BondBits bonds;
  std::int64_t step = 0;
  double external_work = 0.0;  // work done by the loads so far, in units of rho dx^4/dt^2 (J/m)

  // Sixteen hexadecimal digits over all of the above: equal means the same bits.
  std::string hash() const;
};

}  // namespace hackle
