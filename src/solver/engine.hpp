// SPDX-License-Identifier: MIT
// One time step of the whole plate in one precision: tables, tiles and threads around a kernel.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "solver/kernel.hpp"
#include "solver/loading.hpp"
#include "solver/scratch.hpp"
#include "solver/state.hpp"
#include "solver/threads.hpp"

namespace hackle {

struct EngineOptions {
  double dt = 0.0;        // s
  bool heated = false;    // set_heat() will be called
  double fidelity = 0.0;  // share of the critical stretch below which forces are linearised
  Breaking breaking = Breaking::at_once;
  InstructionSet set = InstructionSet::baseline;
  Arithmetic arithmetic = Arithmetic::plain;
};

template <class Real>
class Engine {
 public:
  Engine(const Lattice& lattice, const EngineOptions& options, Threads threads);

  // Sets what acts from now on.
  void set_loads(const Loading& loading);
  // Sets the thermal strain of every node from now on, by Grid::index. The engine must be heated.
  void set_heat(const Lattice& lattice, const std::vector<double>& strain);
  // Work of supports up to the beginning of the last step, in units of rho dx^4/dt^2
  // (src/solver/README.md 3.5).
  double prescribed_work() const;

  // Must be called before the first step, and whenever a state is not the one that step() left;
  // `lattice` is the one the engine was made for. A state at its start gets the thresholds that
  // follow from its displacements, as if it had been there a step earlier.
  void prepare(const Lattice& lattice, State& state);

  // Advances u, v, bonds and thresholds by one step; the rest of the state is the caller's. v
  // changes by `kick` times the acceleration.
  void step(const Lattice& lattice, State& state, double kick);

  // Acceleration of every place at the time of u, in lattice units, as if no node were prescribed.
  void accelerations(const Lattice& lattice, const State& state, Values<Real>& ax,
                     Values<Real>& ay);

  // The bonds that broke in the last step, or those given to note_broken_bonds().
  const std::vector<BrokenBond>& broken_bonds() const { return broken_bonds_; }
  void note_broken_bonds(std::vector<BrokenBond> broken_bonds) {
    broken_bonds_ = std::move(broken_bonds);
  }
  const PathCounts& path_counts() const { return path_counts_; }
  std::size_t bytes() const;  // of all that grows with the plate

 private:
  KernelData<Real> tables(const Lattice& lattice, const Motion<Real>& motion,
                          const State& state) const;
  void let_write(KernelData<Real>& data, Motion<Real>& motion);
  void let_prescribe(KernelData<Real>& data);
  void advance(const KernelData<Real>& data);
  void set_thresholds(const Lattice& lattice);
  Values<Real> thresholds_of(const Lattice& lattice, const State& state) const;
  void set_materials(const Lattice& lattice);
  void survey(const Lattice& lattice, Motion<Real>& motion, const State& state);
  void find_intact(const Lattice& lattice, const BondBits& bonds);
  void break_bonds(BondBits& bonds);
  int tile_of(std::ptrdiff_t place) const;

  KernelFeatures features_;
  NodeLayout layout_;
  int reach_;
  std::vector<BondClass<Real>> classes_;
  int first_on_row_ = 0;
  std::vector<std::uint32_t> all_bonds_;  // words of a node that lacks none
  double acceleration_unit_;              // a lattice unit over 1 m/s2: dt^2/dx
  std::vector<NodeLoad<Real>> loads_;
  std::vector<PrescribedMotion<Real>> prescribed_;
  std::vector<double> prescribed_inertia_;
  std::vector<std::size_t> loads_of_row_, prescribed_of_row_;

  bool late_;
  BoundFactors<Real> bound_;
  Real linear_range_{};
  LinearStencil<Real> stencil_;
  std::vector<std::ptrdiff_t> bond_offsets_;  // from the keeping end of a bond to the other

  Real alpha_{};
  Real min_threshold_{};
  Values<Real> s00_;        // per place; empty unless varied
  Values<Real> threshold_;  // of an untouched plate; empty unless varied

  Values<Real> half_stiffness_, inverse_inertia_;  // per place; empty unless mixed
  Values<Real> alphas_;                            // empty unless mixed with a history
  Values<Real> heat_, tile_heat_;                  // empty unless heated

  std::vector<int> tile_rows_;
  std::vector<int> tile_row_of_;  // per row of nodes
  std::vector<TileRange<Real>> range_, next_range_;
  std::vector<std::uint8_t> intact_, complete_, loaded_;
  Values<Real> next_ux_, next_uy_, next_threshold_;

  Kernel<Real> kernel_;
  Threads threads_;
  std::vector<Rows> tasks_;
  std::vector<Scratch<Real>> scratch_;  // one a thread
  std::vector<BrokenBond> broken_bonds_;
  PathCounts path_counts_{};
};

extern template class Engine<float>;
extern template class Engine<double>;

}  // namespace hackle
