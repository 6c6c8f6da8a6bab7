// SPDX-License-Identifier: MIT
// Short-range repulsion between faces of cracks and fragments, as in LAMMPS's pair peri/pmb (after
// the EMU manual): two unbonded nodes repel each other when they are closer than d = reach min(L,
// 1.5 dx), L their initial distance, with `stiffness` times the micromodulus times (d - r)/delta,
// delta the horizon.
//
// Only nodes that lack a bond are considered, including those at the rims of the plate. LAMMPS also
// lets bonded nodes repel each other once they are closer than d: a second, stiffer law for bonds
// shortened by a tenth, which no bond of glass survives. Faces of a closed crack push each other
// before that (crack_faces.hpp).
//
// With friction, nodes and closed faces that press each other resist sliding; with restitution
// below 1, nodes that part push less (roughness.hpp). What that takes is damped.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "solver/terms/crack_faces.hpp"
#include "solver/terms/open_node.hpp"
#include "solver/terms/roughness.hpp"
#include "solver/terms/term.hpp"

namespace hackle {

class ContactForces final : public Term {
 public:
  ContactForces(const Contact& contact, const Lattice& lattice, double dt);

  std::unique_ptr<Term> clone() const override { return std::make_unique<ContactForces>(*this); }
  std::string_view name() const override { return "contact"; }
  // Finds the nodes that lack a bond, and the bonds that were lost.
  void begin(const Surroundings& around, State& state) override;
  // Takes note of the bonds that broke in the last step: both ends of each lack one now.
  void follow(const Surroundings& around, State& state) override;
  // Finds who pushes whom at the time of u. Adds to what was lost what faces stored before the
  // bonds of the last step broke, and do not since: what is stored at a place depends on which
  // bonds are lost.
  bool update(const Surroundings& around, State& state) override;
  std::span<const LoadedNode> forces() const override { return forces_; }
  std::span<const LoadedNode> drag() const override { return drag_; }
  bool varies() const override { return !roughness_.is_smooth(); }
  double stored() const override { return energy_; }
  double heat_work(const std::vector<double>& before,
                   const std::vector<double>& after) const override;
  // Counts the memory that grows with the plate, not with its damage.
  std::size_t bytes() const override { return place_.size() * sizeof(int); }

 private:
  // Two open nodes without a bond between them.
  struct Pair {
    int one = 0;
    int other = 0;
    double distance = 0.0;  // d, in dx
    double strength = 0.0;  // of the force per (d - r), in units of rho dx^2/dt^2
  };

  int open(const Lattice& lattice, const State& state, int i, int j);
  void find_pairs(int node, const Lattice& lattice, const BondBits& bonds);
  void pair_up(int one, int other, const Lattice& lattice);
  // Removes the bond `bit` kept by node (i, j). Returns its ends.
  Pair lose(const Lattice& lattice, const State& state, int i, int j, int bit);
  // Reads u. Returns false if a node has moved too far for the list of its neighbours.
  bool move_nodes(const Grid& grid, const State& state);
  // Finds the neighbours again.
  void renew(const Lattice& lattice, const State& state);
  // Adds its forces and returns its energy.
  double push(const Pair& pair);
  void resist(OpenNode& one, OpenNode& other, const Vec2& force) const;
  void collect(const Lattice& lattice);

  CrackFaces faces_;
  Roughness roughness_;
  double reach_;
  double strength_;  // for two nodes of the plate's own material
  double unit_;      // lattice unit of acceleration, m/s2
  std::vector<OpenNode> open_;
  std::vector<int> place_;  // index in open_, by Grid::index; -1 for other nodes
  std::unordered_map<std::int64_t, std::vector<int>> cells_;
  std::vector<Pair> pairs_;
  std::vector<LoadedNode> forces_;
  std::vector<LoadedNode> drag_;         // the part of them that only takes energy
  double energy_ = 0.0;                  // stored, in units of rho dx^4/dt^2
  std::optional<double> stored_before_;  // in faces, if bonds broke since update()
};

}  // namespace hackle
