// SPDX-License-Identifier: MIT
#include "solver/cpu/engine.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/stopwatch.hpp"
#include "lattice/carve.hpp"
#include "lattice/needs.hpp"
#include "solver/cpu/kernel_tables.hpp"
#include "solver/cpu/tasks.hpp"
#include "solver/statics/linearised_bonds.hpp"

namespace hackle {
namespace {

// See KernelFeatures.
KernelFeatures features_for(const Needs& needs) {
  return {.guarded = needs.guarded(),
          .varied = needs.varied(),
          .history = needs.history,
          .mixed = needs.mixed,
          .heated = needs.heated};
}

// The stencil of linearised forces is that of one cold material.
double linear_range(const Lattice& lattice, const EngineOptions& options) {
  if (differ(lattice.materials) || options.heated) return 0.0;
  return threshold_of(options.fidelity * lattice.calibration.s0);
}

}  // namespace

template <class Real>
Engine<Real>::Engine(const Lattice& lattice, const EngineOptions& options, Threads threads)
    : features_(features_for(needs_of(lattice, options.heated))),
      layout_(lattice.grid.layout()),
      reach_(lattice.family.reach()),
      classes_(bond_classes<Real>(lattice, options.dt, features_.varied)),
      all_bonds_(static_cast<std::size_t>(lattice.family.words())),
      acceleration_unit_(options.dt * options.dt / lattice.grid.dx),
      loads_of_row_(static_cast<std::size_t>(layout_.ny) + 1),
      late_(options.breaking == Breaking::next_step),
      bound_(bound_factors<Real>(lattice.family)),
      linear_range_(static_cast<Real>(linear_range(lattice, options))),
      stencil_(linear_stencil(classes_)),
      nodes_(lattice, features_),
      tile_rows_(tile_rows(layout_.ny, reach_)),
      tile_row_of_(rows_to_tiles(tile_rows_)),
      next_ux_(layout_.size()),
      next_uy_(layout_.size()),
      next_threshold_(features_.history ? layout_.size() : 0, nodes_.min_threshold),
      kernel_(find_kernel<Real>(options.set, options.arithmetic, features_)),
      threads_(std::move(threads)),
      slab_(options.slab),
      halo_(slab_, layout_, reach_, tile_rows_),
      tasks_(share_out(tile_rows_, threads_.count())),
      scratch_(static_cast<std::size_t>(threads_.count()),
               Scratch<Real>(layout_.groups() * NodeLayout::group, reach_, linear_range_ > 0)) {
  if (!slab_.is_whole()) share_out_slab();
  const auto on_row = [](const BondClass<Real>& k) { return k.rows == 0; };
  first_on_row_ = static_cast<int>(std::ranges::find_if(classes_, on_row) - classes_.begin());
  const auto tiles = (tile_rows_.size() - 1) * static_cast<std::size_t>(layout_.groups());
  range_.resize(tiles);
  next_range_.resize(tiles);
  intact_.resize(tiles);
  complete_.resize(tiles);
  loaded_.resize(tiles);
  bond_offsets_.resize(32 * all_bonds_.size());
  lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
    all_bonds_[static_cast<std::size_t>(bit / 32)] |= std::uint32_t{1} << (bit % 32);
    bond_offsets_[static_cast<std::size_t>(bit)] = b * layout_.stride() + a;
  });
  if (features_.heated) set_heat(lattice, {});
}

template <class Real>
void Engine<Real>::set_heat(const Lattice& lattice, const std::vector<double>& strain) {
  heat_.assign(layout_.size(), Real{0});
  tile_heat_.assign(range_.size(), Real{0});
  if (strain.empty()) return;
  for (int j = 0; j < layout_.ny; ++j)
    for (int i = 0; i < layout_.nx; ++i) {
      const std::ptrdiff_t at = layout_.at(i, j);
      const auto own = static_cast<Real>(strain[lattice.grid.index(i, j)]);
      heat_[static_cast<std::size_t>(at)] = own;
      Real& max = tile_heat_[static_cast<std::size_t>(tile_of(at))];
      max = std::max(max, std::abs(own));
    }
}

template <class Real>
int Engine<Real>::tile_of(std::ptrdiff_t place) const {
  const auto j = place / layout_.stride();
  const auto column = place - layout_.at(layout_.first_column(), static_cast<int>(j));
  return tile_row_of_[static_cast<std::size_t>(j)] * layout_.groups() +
         static_cast<int>(column / NodeLayout::group);
}

template <class Real>
void Engine<Real>::set_actions(const Actions& actions) {
  loads_ = node_loads<Real>(actions.forces, acceleration_unit_);
  loads_of_row_ = first_of_rows(actions.forces, layout_.ny);
  prescribed_ = prescribed_motions<Real>(actions.prescribed);
  prescribed_of_row_ = first_of_rows(actions.prescribed, layout_.ny);
  prescribed_inertia_.clear();
  std::ranges::fill(loaded_, std::uint8_t{0});
  const auto mark = [this](int i, int j) {
    loaded_[static_cast<std::size_t>(tile_of(layout_.at(i, j)))] = 1;
  };
  for (const LoadedNode& node : actions.forces) mark(node.i, node.j);
  for (const PrescribedNode& node : actions.prescribed) {
    mark(node.i, node.j);
    prescribed_inertia_.push_back(node.inertia);
  }
}

template <class Real>
double Engine<Real>::prescribed_work() const {
  RowSum sum(slab_);
  for (int j = slab_.begin(); j < slab_.end(layout_.ny); ++j)
    for (auto k = prescribed_of_row_[static_cast<std::size_t>(j)];
         k < prescribed_of_row_[static_cast<std::size_t>(j) + 1]; ++k)
      sum.add(j, prescribed_inertia_[k] * static_cast<double>(prescribed_[k].work));
  return sum.value();
}

template <class Real>
void Engine<Real>::let_prescribe(KernelData<Real>& data) {
  if (prescribed_.empty()) return;
  data.prescribed = prescribed_.data();
  data.prescribed_of_row = prescribed_of_row_.data();
}

template <class Real>
void Engine<Real>::prepare(const Lattice& lattice, State& state) {
  auto& motion = std::get<Motion<Real>>(state.motion);
  if (features_.history && (motion.threshold.empty() || state.is_start()))
    motion.threshold = thresholds_of(lattice, state);
  find_intact(lattice, state.bonds);
  survey(lattice, motion, state);
}

template <class Real>
Values<Real> Engine<Real>::thresholds_of(const Lattice& lattice, const State& state) const {
  std::vector<double> heat;
  for (int j = 0; j < layout_.ny && features_.heated; ++j)
    for (int i = 0; i < layout_.nx; ++i)
      heat.push_back(static_cast<double>(heat_[static_cast<std::size_t>(layout_.at(i, j))]));
  const std::vector<double> critical =
      LinearisedBonds(lattice, state, threads_, heat).critical_stretches(displacements_of(state));
  Values<Real> threshold = nodes_.threshold;
  for (int j = 0; j < layout_.ny; ++j)
    for (int i = 0; i < layout_.nx; ++i)
      threshold[static_cast<std::size_t>(layout_.at(i, j))] =
          static_cast<Real>(threshold_of(critical[lattice.grid.index(i, j)]));
  return threshold;
}

template <class Real>
void Engine<Real>::find_intact(const Lattice& lattice, const BondBits& bonds) {
  std::ranges::fill(intact_, std::uint8_t{1});
  const auto& words = bonds.words();
  for (int j = 0; j < layout_.ny; ++j)
    for (int q = 0; q < layout_.groups() * NodeLayout::group; ++q) {
      const std::ptrdiff_t at = layout_.at(layout_.first_column(), j) + q;
      for (std::size_t word = 0; word < all_bonds_.size(); ++word)
        if (words[word * bonds.plane() + static_cast<std::size_t>(at)] != all_bonds_[word])
          intact_[static_cast<std::size_t>(tile_of(at))] = 0;
    }
  std::ranges::fill(complete_, std::uint8_t{1});
  const auto degree = degrees(lattice.grid, lattice.family, bonds);
  for (int j = 0; j < layout_.ny; ++j)
    for (int i = 0; i < layout_.nx; ++i)
      if (degree[lattice.grid.index(i, j)] != lattice.family.bonds())
        complete_[static_cast<std::size_t>(tile_of(layout_.at(i, j)))] = 0;
  if (!lattice.surface.empty()) find_surfaces(lattice);
}

// Linearised forces are those of bonds of the same stiffness: a tile that a bond of a stiffened
// node reaches is not complete. No tile is smaller than the reach.
template <class Real>
void Engine<Real>::find_surfaces(const Lattice& lattice) {
  for_nodes(lattice.grid, [&](int i, int j) {
    if (lattice.surface[lattice.grid.index(i, j)] == 1.0F) return;
    for (const int a : {-reach_, 0, reach_})
      for (const int b : {-reach_, 0, reach_}) {
        const int column = std::clamp(i + a, 0, layout_.nx - 1);
        const int row = std::clamp(j + b, 0, layout_.ny - 1);
        complete_[static_cast<std::size_t>(tile_of(layout_.at(column, row)))] = 0;
      }
  });
}

template <class Real>
void Engine<Real>::survey(const Lattice& lattice, Motion<Real>& motion, const State& state) {
  next_ux_ = motion.ux;
  next_uy_ = motion.uy;
  KernelData<Real> data = tables(lattice, motion, state);
  let_write(data, motion);
  kernel_.survey(data, {0, layout_.ny});
  const auto& threshold = features_.history ? motion.threshold : nodes_.threshold;
  for (TileRange<Real>& range : next_range_) {
    range.moving = 0;
    range.min_threshold = std::numeric_limits<Real>::max();
  }
  for (int j = 0; j < layout_.ny; ++j)
    for (int i = 0; i < layout_.nx; ++i) {
      const auto at = static_cast<std::size_t>(layout_.at(i, j));
      TileRange<Real>& range = next_range_[static_cast<std::size_t>(tile_of(layout_.at(i, j)))];
      if (motion.ux[at] != 0 || motion.uy[at] != 0 || motion.vx[at] != 0 || motion.vy[at] != 0)
        range.moving = 1;
      if (features_.varied) range.min_threshold = std::min(range.min_threshold, threshold[at]);
    }
  range_ = next_range_;
}

template <class Real>
KernelData<Real> Engine<Real>::tables(const Lattice& lattice, const Motion<Real>& motion,
                                      const State& state) const {
  KernelData<Real> data;
  data.layout = layout_;
  data.reach = reach_;
  data.classes = classes_.data();
  data.class_count = static_cast<int>(classes_.size());
  data.first_on_row = first_on_row_;
  data.ux = motion.ux.data();
  data.uy = motion.uy.data();
  data.starts = state.is_start();
  data.bonds = state.bonds.words().data();
  data.unbreakable = lattice.unbreakable.empty() ? nullptr : lattice.unbreakable.words().data();
  data.plane = state.bonds.plane();
  data.late = late_;
  data.threshold = features_.history ? motion.threshold.data() : nodes_.threshold.data();
  data.s00 = nodes_.s00.data();
  data.alpha = nodes_.alpha;
  data.half_stiffness = nodes_.half_stiffness.data();
  data.inverse_inertia = nodes_.inverse_inertia.data();
  data.alphas = nodes_.alphas.data();
  data.heat = heat_.data();
  data.tile_heat = tile_heat_.data();
  data.loads = loads_.data();
  data.loads_of_row = loads_of_row_.data();
  data.tiles = {tile_rows_.data(), static_cast<int>(tile_rows_.size()) - 1, layout_.groups()};
  data.range = range_.data();
  data.intact = intact_.data();
  data.loaded = loaded_.data();
  data.bound = bound_;
  data.min_threshold = nodes_.min_threshold;
  data.complete = complete_.data();
  data.linear_range = linear_range_;
  data.stencil = &stencil_;
  return data;
}

template <class Real>
void Engine<Real>::let_write(KernelData<Real>& data, Motion<Real>& motion) {
  data.vx = motion.vx.data();
  data.vy = motion.vy.data();
  data.next_ux = next_ux_.data();
  data.next_uy = next_uy_.data();
  data.next_threshold = next_threshold_.data();
  data.next_range = next_range_.data();
}

template <class Real>
void Engine<Real>::advance(const KernelData<Real>& data, std::span<const Rows> tasks) {
  threads_.for_tasks(static_cast<int>(tasks.size()), [&](int task, int thread) {
    kernel_.advance(data, scratch_[static_cast<std::size_t>(thread)],
                    tasks[static_cast<std::size_t>(task)]);
  });
}

// The rows at both ends are tasks of their own, so that they can be sent while the rest moves.
template <class Real>
void Engine<Real>::share_out_slab() {
  all_tasks_ = share_out(tile_rows_, threads_.count());
  tasks_.clear();
  std::vector<int> inner;
  for (std::size_t t = 0; t + 1 < tile_rows_.size(); ++t) {
    const Rows rows{tile_rows_[t], tile_rows_[t + 1]};
    if (!slab_.owns(rows.begin)) continue;
    if (halo_.is_needed(rows.begin, rows.end)) {
      tasks_.push_back(rows);
      continue;
    }
    if (inner.empty()) inner.push_back(rows.begin);
    inner.push_back(rows.end);
  }
  awaited_tasks_ = tasks_.size();
  if (inner.empty()) return;
  const std::vector<Rows> rest = share_out(inner, threads_.count());
  tasks_.insert(tasks_.end(), rest.begin(), rest.end());
}

// Differences across the borders of tasks belong to the tiles on both sides.
template <class Real>
void Engine<Real>::join(const KernelData<Real>& data) {
  for (const Rows& task : tasks_)
    if (task.begin > 0) kernel_.join(data, task.begin);
  const int end = slab_.end(layout_.ny);
  if (end < layout_.ny) kernel_.join(data, end);
}

template <class Real>
void Engine<Real>::advance_slab(const KernelData<Real>& data) {
  const std::span tasks(tasks_);
  {
    const Stopwatch watch(busy_seconds_);
    advance(data, tasks.first(awaited_tasks_));
  }
  halo_.begin({&next_ux_, &next_uy_, &next_threshold_});
  {
    const Stopwatch watch(busy_seconds_);
    advance(data, tasks.subspan(awaited_tasks_));
  }
  halo_.end();
  join(data);
  halo_.exchange(next_range_);
}

// Rows at rest take less time than those that break: rows change hands where the slowest rank takes
// much longer than the mean. It costs about as much as a step, and changes no bit.
template <class Real>
void Engine<Real>::balance(State& state) {
  constexpr int steps_between = 256;
  constexpr double worth_it = 1.1;
  if (slab_.is_whole() || ++steps_since_ < steps_between) return;
  steps_since_ = 0;
  const std::vector<double> own{std::exchange(busy_seconds_, 0.0)};
  const auto seconds = slab_.ranks->gather(bytes_to_send(own)).template as<double>();
  const double mean = std::accumulate(seconds.begin(), seconds.end(), 0.0) / slab_.ranks->count();
  if (std::ranges::max(seconds) < worth_it * mean) return;
  std::vector<int> begins = slabs_of_equal_cost(slab_, tile_rows_, seconds);
  if (begins == slab_.begins) return;
  complete(state);
  slab_.begins = std::move(begins);
  halo_ = Halo<Real>(slab_, layout_, reach_, tile_rows_);
  share_out_slab();
}

template <class Real>
void Engine<Real>::complete(State& state) {
  if (slab_.is_whole()) return;
  auto& motion = std::get<Motion<Real>>(state.motion);
  for (auto* values : {&motion.ux, &motion.uy, &motion.vx, &motion.vy}) halo_.complete(*values);
  if (features_.history) halo_.complete(motion.threshold);
  halo_.complete(range_);
}

template <class Real>
void Engine<Real>::step(const Lattice& lattice, State& state, double kick) {
  auto& motion = std::get<Motion<Real>>(state.motion);
  KernelData<Real> data = tables(lattice, motion, state);
  data.kick = static_cast<Real>(kick);
  let_write(data, motion);
  let_prescribe(data);
  if (slab_.is_whole()) {
    advance(data, tasks_);
    join(data);
  } else {
    advance_slab(data);
  }
  break_bonds(state.bonds);
  std::swap(motion.ux, next_ux_);
  std::swap(motion.uy, next_uy_);
  if (features_.history) std::swap(motion.threshold, next_threshold_);
  std::swap(range_, next_range_);
  balance(state);
}

// A bond is kept in the row of its lower end, but tasks above also read it: bonds are broken after
// all tasks have finished. Two blocks of columns record a bond in the margin between them; it is
// removed once.
template <class Real>
void Engine<Real>::break_bonds(BondBits& bonds) {
  broken_bonds_.clear();
  for (const BrokenBond& broken : found_broken()) {
    const int bond = 32 * broken.word + std::countr_zero(broken.bit);
    if (!bonds.holds(broken.at, bond)) continue;
    bonds.clear(broken.at, bond);
    broken_bonds_.push_back(broken);
    const auto here = static_cast<std::size_t>(tile_of(broken.at));
    const auto there = static_cast<std::size_t>(
        tile_of(broken.at + bond_offsets_[static_cast<std::size_t>(bond)]));
    intact_[here] = complete_[here] = complete_[there] = 0;
  }
}

// Of all threads and ranks.
template <class Real>
std::vector<BrokenBond> Engine<Real>::found_broken() {
  std::vector<BrokenBond> found;
  for (Scratch<Real>& scratch : scratch_) {
    found.insert(found.end(), scratch.broken_bonds.begin(), scratch.broken_bonds.end());
    scratch.broken_bonds.clear();
    for (std::size_t path = 0; path < path_counts_.size(); ++path)
      path_counts_[path] += std::exchange(scratch.counts[path], 0);
  }
  return slab_.is_whole() ? found : halo_.all_of(found);
}

template <class Real>
std::vector<Vec2> Engine<Real>::accelerations(const Lattice& lattice, const State& state) {
  Values<Real> ax(layout_.size()), ay(layout_.size());
  KernelData<Real> data = tables(lattice, std::get<Motion<Real>>(state.motion), state);
  data.ax = ax.data();
  data.ay = ay.data();
  advance(data, slab_.is_whole() ? tasks_ : all_tasks_);
  std::vector<Vec2> result(lattice.grid.nodes());
  for (int j = 0; j < layout_.ny; ++j)
    for (int i = 0; i < layout_.nx; ++i) {
      const auto at = static_cast<std::size_t>(layout_.at(i, j));
      result[lattice.grid.index(i, j)] = {ax[at], ay[at]};
    }
  return result;
}

template <class Real>
std::size_t Engine<Real>::bytes() const {
  std::size_t sum = 0;
  for (const auto* values : {&next_ux_, &next_uy_, &next_threshold_, &heat_, &tile_heat_})
    sum += bytes_of(*values);
  sum += nodes_.bytes();
  return sum + 2 * range_.size() * sizeof(TileRange<Real>) + 3 * intact_.size();
}

template class Engine<float>;
template class Engine<double>;

std::unique_ptr<Stepper> make_engine(Precision precision, const Lattice& lattice,
                                     const EngineOptions& options, const Threads& threads) {
  if (precision == Precision::f32)
    return std::make_unique<Engine<float>>(lattice, options, threads);
  return std::make_unique<Engine<double>>(lattice, options, threads);
}

}  // namespace hackle
