// SPDX-License-Identifier: MIT
// Short-range repulsion of the faces of cracks and of fragments, as in LAMMPS's pair peri/pmb
// (after the EMU manual): two nodes that no bond joins push each other apart when they are nearer
// than d = reach min(L, 1.5 dx), L their distance at rest, with `stiffness` times the micromodulus
// times (d - r)/delta, delta the horizon.
//
// Only nodes that lack a bond are looked at, those at the rims of the plate included. LAMMPS pushes
// nodes that are still bonded, too, once they are nearer than d: a second, stiffer law for bonds
// that are shortened by a tenth, which no bond of glass lives to see.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "lattice/lattice.hpp"
#include "lattice/load_map.hpp"
#include "solver/kernel.hpp"
#include "solver/order_free_sum.hpp"
#include "solver/state.hpp"

namespace hackle {

class ContactForces {
 public:
  ContactForces(const Contact& contact, const Lattice& lattice, double dt);

  // Finds the nodes that lack a bond. To be called before anything else, and whenever a state is
  // not the one of the last step.
  void begin(const Lattice& lattice, const State& state);
  // The bonds that broke in the last step: both ends of each lack one now.
  void take_note(const Lattice& lattice, const State& state, std::span<const Loss> losses);
  // Finds who pushes whom at the time of u.
  void update(const Lattice& lattice, const State& state);

  // What update() found: each node once, ordered by index.
  const std::vector<LoadedNode>& forces() const { return forces_; }
  // Stored in contacts, in units of rho dx^4/dt^2.
  double energy() const { return energy_; }
  // Of what grows with the plate, and not with what is broken of it.
  std::size_t bytes() const { return place_.size() * sizeof(int); }

 private:
  // A node that lacks a bond.
  struct Open {
    int i = 0;
    int j = 0;
    Vec2 home{0, 0};  // where it was when the pairs were found, in dx from the centre
    Vec2 u{0, 0};
    OrderFreeSum force;
  };
  // Two of them that no bond joins.
  struct Pair {
    int one = 0;
    int other = 0;
    double distance = 0.0;  // d, in dx
    double strength = 0.0;  // of the force per (d - r), in units of rho dx^2/dt^2
  };

  int open(const Lattice& lattice, const State& state, int i, int j);
  void find_pairs(int node, const Lattice& lattice, const BondBits& bonds);
  void pair_up(int one, int other, const Lattice& lattice);
  // Reads u. False when a node has wandered too far for the pairs.
  bool follow(const Grid& grid, const State& state);
  // Seeks the pairs anew.
  void renew(const Lattice& lattice, const State& state);
  // The energy it stores.
  double push(const Pair& pair);
  void collect(const Lattice& lattice);

  double reach_;
  double strength_;  // of two nodes of the plate's own material
  double unit_;      // lattice unit of acceleration, m/s2
  std::vector<Open> open_;
  std::vector<int> place_;  // in open_, by Grid::index; -1 for nodes that are not
  std::unordered_map<std::int64_t, std::vector<int>> cells_;
  std::vector<Pair> pairs_;
  std::vector<LoadedNode> forces_;
  double energy_ = 0.0;
};

}  // namespace hackle
