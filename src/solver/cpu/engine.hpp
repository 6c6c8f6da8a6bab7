// SPDX-License-Identifier: MIT
// One time step of the whole plate in one precision: tables, tiles and threads around a kernel.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "solver/cpu/halo.hpp"
#include "solver/cpu/kernel.hpp"
#include "solver/cpu/node_tables.hpp"
#include "solver/cpu/scratch.hpp"
#include "solver/state.hpp"
#include "solver/stepper.hpp"
#include "solver/threads.hpp"

namespace hackle {

struct EngineOptions {
  double dt = 0.0;        // s
  bool heated = false;    // set_heat() will be called
  double fidelity = 0.0;  // share of the critical stretch below which forces are linearised
  Breaking breaking = Breaking::at_once;
  InstructionSet set = InstructionSet::baseline;
  Arithmetic arithmetic = Arithmetic::plain;
  Slab slab;  // the rows that are moved here
};

template <class Real>
class Engine final : public Stepper {
 public:
  Engine(const Lattice& lattice, const EngineOptions& options, Threads threads);

  std::unique_ptr<Stepper> clone() const override { return std::make_unique<Engine>(*this); }
  void prepare(const Lattice& lattice, State& state) override;
  void set_actions(const Actions& actions) override;
  void set_heat(const Lattice& lattice, const std::vector<double>& strain) override;
  void step(const Lattice& lattice, State& state, double kick) override;
  std::vector<Vec2> accelerations(const Lattice& lattice, const State& state) override;
  const Slab& slab() const override { return slab_; }
  void complete(State& state) override;
  double prescribed_work() const override;
  const std::vector<BrokenBond>& broken_bonds() const override { return broken_bonds_; }
  void note_broken_bonds(std::vector<BrokenBond> broken_bonds) override {
    broken_bonds_ = std::move(broken_bonds);
  }
  const PathCounts& path_counts() const override { return path_counts_; }
  std::size_t bytes() const override;

 private:
  KernelData<Real> tables(const Lattice& lattice, const Motion<Real>& motion,
                          const State& state) const;
  void let_write(KernelData<Real>& data, Motion<Real>& motion);
  void let_prescribe(KernelData<Real>& data);
  void advance(const KernelData<Real>& data, std::span<const Rows> tasks);
  void advance_slab(const KernelData<Real>& data);
  void join(const KernelData<Real>& data);
  void share_out_slab();
  void balance(State& state);
  std::vector<BrokenBond> found_broken();
  Values<Real> thresholds_of(const Lattice& lattice, const State& state) const;
  void survey(const Lattice& lattice, Motion<Real>& motion, const State& state);
  void find_intact(const Lattice& lattice, const BondBits& bonds);
  void find_surfaces(const Lattice& lattice);
  void break_bonds(BondBits& bonds);
  int tile_of(std::ptrdiff_t place) const;

  KernelFeatures features_;
  NodeLayout layout_;
  int reach_;
  std::vector<BondClass<Real>> classes_;
  int first_on_row_ = 0;
  std::vector<std::uint32_t> all_bonds_;  // words of a node with all bonds
  double acceleration_unit_;              // lattice unit over 1 m/s2: dt^2/dx
  std::vector<NodeLoad<Real>> loads_;
  std::vector<PrescribedMotion<Real>> prescribed_;
  std::vector<double> prescribed_inertia_;
  std::vector<std::size_t> loads_of_row_, prescribed_of_row_;

  bool late_;
  BoundFactors<Real> bound_;
  Real linear_range_{};
  LinearStencil<Real> stencil_;
  std::vector<std::ptrdiff_t> bond_offsets_;  // from the keeping end of a bond to the other

  NodeTables<Real> nodes_;
  Values<Real> heat_, tile_heat_;  // empty unless heated

  std::vector<int> tile_rows_;
  std::vector<int> tile_row_of_;  // per row of nodes
  std::vector<TileRange<Real>> range_, next_range_;
  std::vector<std::uint8_t> intact_, complete_, loaded_;
  Values<Real> next_ux_, next_uy_, next_threshold_;

  Kernel<Real> kernel_;
  Threads threads_;
  Slab slab_;
  Halo<Real> halo_;
  std::vector<Rows> tasks_;      // of the slab; first those that other ranks wait for
  std::vector<Rows> all_tasks_;  // of the plate, where the slab is less
  std::size_t awaited_tasks_ = 0;
  double busy_seconds_ = 0.0;  // of this rank since its rows were last weighed
  int steps_since_ = 0;
  std::vector<Scratch<Real>> scratch_;  // one per thread
  std::vector<BrokenBond> broken_bonds_;
  PathCounts path_counts_{};
};

extern template class Engine<float>;
extern template class Engine<double>;

std::unique_ptr<Stepper> make_engine(Precision precision, const Lattice& lattice,
                                     const EngineOptions& options, const Threads& threads);

}  // namespace hackle
