// SPDX-License-Identifier: MIT
// The kernels of one precision and one instruction set: compiled once for each pair, into the
// namespace HACKLE_INSTRUCTION_SET. Calls no function of the standard library that the linker could
// keep for everybody.
//
// Bits do not depend on the instruction set: every node is computed by the same IEEE operations in
// the same order, one lane a node, and contraction is off.
//
// The length of this file is that of one class, the sweep, whose parts are called for every row and
// must be inlined into each other.
#include "solver/cpu/kernel_advance.hpp"

#include "solver/cpu/kernel_linear.hpp"
#include "solver/cpu/kernel_paths.hpp"
#include "solver/cpu/kernel_rows.hpp"
#include "solver/cpu/kernel_survey.hpp"

namespace hackle::HACKLE_INSTRUCTION_SET {
namespace {

using Real = HACKLE_REAL;

void note_broken_bonds(void* broken_bonds, std::ptrdiff_t at, int word, std::uint32_t bit) {
  note_broken_bond(*static_cast<std::vector<BrokenBond>*>(broken_bonds), {at, word, bit});
}

// Advances the rows of a block of columns by a step, from bottom to top (src/solver/README.md 4.1).
template <KernelFeatures features>
class Sweep {
 public:
  // The columns [first, end) of the layout, counted from its first.
  Sweep(const KernelData<Real>& data, Scratch<Real>& scratch, Rows rows, int first, int end)
      : data_(data),
        scratch_(scratch),
        rows_(rows),
        first_(first),
        columns_(end - first),
        paths_(data, scratch, first) {
    const int margin = (data.reach + lanes<Real> - 1) / lanes<Real> * lanes<Real>;
    const bool last = end == data.layout.groups() * NodeLayout::group;
    begin_ = first == 0 ? 0 : -margin;
    end_ = last ? columns_ : columns_ + margin;
    scratch.bond.clear();
    if constexpr (features.history)
      for (const int row : {2, 5})
        fill(scratch.bond.row(row) - NodeLayout::group, columns_ + 2 * NodeLayout::group);
    for (int row = 0; row <= data.reach; ++row) {
      waiting_[row] = sums(scratch.down, row);
      reset(waiting_[row]);
    }
    work_ = row_work();
  }

  void run() {
    const TileGrid& tiles = data_.tiles;
    int j = rows_.begin > data_.reach ? rows_.begin - data_.reach : 0;
    int tile_row = 0;
    while (tiles.first_row[tile_row + 1] <= j) ++tile_row;
    choose_paths(tile_row);
    for (; j < rows_.end; ++j) {
      if (j == tiles.first_row[tile_row + 1]) choose_paths(++tile_row);
      add_bonds_above(j);
      if (j < rows_.begin) continue;
      add_bonds_on_row(j);
      if constexpr (features.mixed) divide_by_inertia(j);
      add_loads(j);
      if (data_.prescribed_of_row != nullptr) prescribe(j);
      if (data_.ax == nullptr)
        advance(j, tile_row);
      else
        show(j);
      if (j + 1 == tiles.first_row[tile_row + 1] && data_.ax == nullptr) summarise(tile_row);
    }
  }

 private:
  // Returns the place of column 0 of the block in row j.
  std::ptrdiff_t place(int j) const {
    return data_.layout.at(data_.layout.first_column(), j) + first_;
  }

  static Sums<Real> sums(ScratchRows<Real>& rows, int k) {
    return {rows.row(3 * k), rows.row(3 * k + 1), rows.row(3 * k + 2)};
  }
  const Sums<Real>& waiting(int j) const { return waiting_[j % (data_.reach + 1)]; }

  static void fill(Real* values, int count) {
    for (int q = 0; q < count; ++q) values[q] = unstretched<Real>;
  }
  void reset(const Sums<Real>& sums) {
    for (std::ptrdiff_t q = begin_; q < end_; ++q) sums.x[q] = sums.y[q] = 0;
    if constexpr (features.history) fill(sums.least + begin_, end_ - begin_);
  }

  // A tile is counted by the task that its rows belong to.
  bool counts(int tile_row) const {
    return data_.ax == nullptr && data_.tiles.first_row[tile_row] >= rows_.begin;
  }
  void choose_paths(int tile_row);
  RowWork<Real> row_work();
  void begin_row(int j);
  void point_to_bits(const BondClass<Real>& k);
  void add_bonds_above(int j);
  void add_bonds_on_row(int j);
  // A tile that has ever moved counts as moving.
  bool was_moving(int tile_row, std::ptrdiff_t q) const {
    return data_.range[data_.tiles.index(tile_row, static_cast<int>((first_ + q) >> 4))].moving !=
           0;
  }
  void linearise();
  void divide_by_inertia(int j);
  void add_loads(int j);
  void prescribe(int j);
  void show(int j);
  void advance(int j, int tile_row);
  void move_threshold(std::ptrdiff_t place, std::ptrdiff_t q, Vector<Real> e);
  void summarise(int tile_row);

  const KernelData<Real>& data_;
  Scratch<Real>& scratch_;
  Rows rows_;
  int first_;      // column of the layout at which the block begins
  int columns_;    // of the block
  int begin_ = 0;  // of the block and the columns that reach into it, from its first column
  int end_ = 0;
  PathChooser<Real, features> paths_;
  RowWork<Real> work_{};
  Sums<Real> waiting_[NodeLayout::group + 1];
};

template <KernelFeatures features>
void Sweep<features>::choose_paths(int tile_row) {
  paths_.choose(tile_row, begin_, end_);
  if (counts(tile_row)) paths_.count(columns_);
  for (int q = 0; q < columns_; ++q) scratch_.seen.row(0)[q] = 0;
  if constexpr (features.history) fill(scratch_.seen.row(1), columns_);
}

// Prepares the values shared by all rows of the block.
template <KernelFeatures features>
RowWork<Real> Sweep<features>::row_work() {
  RowWork<Real> work{};
  work.runs = scratch_.runs.data();
  work.columns = columns_;
  work.stride = data_.layout.stride();
  work.up = sums(scratch_.up, 0);
  work.first = sums(scratch_.bond, 0);
  work.second = sums(scratch_.bond, 1);
  return work;
}

template <KernelFeatures features>
void Sweep<features>::begin_row(int j) {
  const std::ptrdiff_t at = place(j);
  work_.row.ux = data_.ux + at;
  work_.row.uy = data_.uy + at;
  if constexpr (features.varied) work_.row.threshold = data_.threshold + at;
  if constexpr (features.mixed) work_.row.half_stiffness = data_.half_stiffness + at;
  if constexpr (features.heated) work_.row.heat = data_.heat + at;
  work_.row.place = at;
  // Bonds of lower rows are recorded by the task that these rows belong to; bonds in the margin
  // between two blocks by both.
  work_.row.broken_bonds =
      j >= rows_.begin && data_.ax == nullptr ? &scratch_.broken_bonds : nullptr;
  work_.row.late = data_.late;
  work_.run_count = scratch_.run_count;
  // For later rows advance() has cleared the sum.
  if (j <= rows_.begin) reset(work_.up);
}

template <KernelFeatures features>
void Sweep<features>::point_to_bits(const BondClass<Real>& k) {
  const auto at = k.word * static_cast<std::ptrdiff_t>(data_.plane) + work_.row.place;
  work_.row.bonds = data_.bonds + at;
  if constexpr (features.guarded)
    if (!(features.mixed || features.heated) || data_.unbreakable != nullptr)
      work_.row.unbreakable = data_.unbreakable + at;
}

// Adds the bonds that row j keeps to rows above it, to its own sum and to the sums that wait there.
template <KernelFeatures features>
void Sweep<features>::add_bonds_above(int j) {
  begin_row(j);
  if (!scratch_.computes) return;
  for (int c = 0; c < data_.first_on_row; ++c) {
    const BondClass<Real>& k = data_.classes[c];
    const int target = j + k.rows;
    if (target >= data_.layout.ny || target < rows_.begin) continue;
    point_to_bits(k);
    work_.down = waiting(target);
    if (k.images == 2)
      add_quads<Real, features>(k, work_);
    else
      add_columns<Real, features>(k, work_);
  }
}

// Completes the sum of row j: subtracts the sum that waited for it, whose place a later row takes,
// and adds the bonds along the row.
template <KernelFeatures features>
void Sweep<features>::add_bonds_on_row(int j) {
  const Sums<Real>& down = waiting(j);
  for (std::ptrdiff_t q = 0; q < columns_; q += lanes<Real>) {
    store(work_.up.x + q, load(work_.up.x + q) - load(down.x + q));
    store(work_.up.y + q, load(work_.up.y + q) - load(down.y + q));
    store(down.x + q, Vector<Real>{});
    store(down.y + q, Vector<Real>{});
    if constexpr (features.history) {
      lower(work_.up.least, q, load(down.least + q));
      store(down.least + q, every(unstretched<Real>));
    }
  }
  for (int c = data_.first_on_row; scratch_.computes && c < data_.class_count; ++c) {
    const BondClass<Real>& k = data_.classes[c];
    point_to_bits(k);
    add_row<Real, features>(k, work_);
  }
  linearise();
}

template <KernelFeatures features>
void Sweep<features>::linearise() {
  for (int n = 0; n < scratch_.run_count; ++n) {
    const TileRun& run = scratch_.runs[n];
    if (!run.linear) continue;
    const Columns own{run.begin > 0 ? run.begin : 0, run.end < columns_ ? run.end : columns_};
    if (own.begin < own.end) linear_row(*data_.stencil, work_, scratch_.folded, own);
  }
}

// Called before loads are added, which already are accelerations.
template <KernelFeatures features>
void Sweep<features>::divide_by_inertia(int j) {
  const Real* inverse = data_.inverse_inertia + place(j);
  for (std::ptrdiff_t q = 0; q < columns_; q += lanes<Real>) {
    store(work_.up.x + q, load(work_.up.x + q) * load(inverse + q));
    store(work_.up.y + q, load(work_.up.y + q) * load(inverse + q));
  }
}

template <KernelFeatures features>
void Sweep<features>::add_loads(int j) {
  const Sums<Real>& force = work_.up;
  for (std::size_t n = data_.loads_of_row[j]; n < data_.loads_of_row[j + 1]; ++n) {
    const NodeLoad<Real>& load = data_.loads[n];
    const int q = load.i - data_.layout.first_column() - first_;
    if (q < 0 || q >= columns_) continue;
    force.x[q] += load.x;
    force.y[q] += load.y;
  }
}

// Sets velocity and force of prescribed nodes so that advance() moves them as prescribed.
template <KernelFeatures features>
void Sweep<features>::prescribe(int j) {
  for (std::size_t n = data_.prescribed_of_row[j]; n < data_.prescribed_of_row[j + 1]; ++n) {
    PrescribedMotion<Real>& node = data_.prescribed[n];
    const int q = node.i - data_.layout.first_column() - first_;
    if (q < 0 || q >= columns_) continue;
    node.work = 0;
    const auto along = [&](Real& force, Real& v, Real move) {
      const Real push = move - (v + force);
      node.work += Real{0.5} * push * (v + move);
      if (data_.starts) node.work += Real{0.5} * force * v;
      v = move;
      force = 0;
    };
    const std::ptrdiff_t at = place(j) + q;
    if (node.along_x) along(work_.up.x[q], data_.vx[at], node.x);
    if (node.along_y) along(work_.up.y[q], data_.vy[at], node.y);
  }
}

template <KernelFeatures features>
void Sweep<features>::show(int j) {
  for (std::ptrdiff_t q = 0; q < columns_; q += lanes<Real>) {
    store(data_.ax + place(j) + q, load(work_.up.x + q));
    store(data_.ay + place(j) + q, load(work_.up.y + q));
  }
  reset(work_.up);
}

template <KernelFeatures features>
void Sweep<features>::advance(int j, int tile_row) {
  const Sums<Real>& force = work_.up;
  const std::ptrdiff_t at = place(j);
  for (std::ptrdiff_t q = 0; q < columns_; q += lanes<Real>) {
    const std::ptrdiff_t n = at + q;
    const Vector<Real> vx = load(data_.vx + n) + data_.kick * load(force.x + q);
    const Vector<Real> vy = load(data_.vy + n) + data_.kick * load(force.y + q);
    const Vector<Real> ux = load(data_.ux + n) + vx, uy = load(data_.uy + n) + vy;
    store(data_.vx + n, vx);
    store(data_.vy + n, vy);
    store(data_.next_ux + n, ux);
    store(data_.next_uy + n, uy);
    store(force.x + q, Vector<Real>{});
    store(force.y + q, Vector<Real>{});
    if (!was_moving(tile_row, q)) {
      Real* seen = scratch_.seen.row(0) + q;
      store<Real>(seen, (Vector<Real>)((Bits<Real>)load(seen) | (Bits<Real>)ux | (Bits<Real>)uy |
                                       (Bits<Real>)vx | (Bits<Real>)vy));
    }
    if constexpr (features.history) {
      move_threshold(n, q, load(force.least + q));
      store(force.least + q, every(unstretched<Real>));
    }
  }
}

// Computes s0 = s00 - alpha s_min (paper Eq. 11) for the next step, as e.
template <KernelFeatures features>
void Sweep<features>::move_threshold(std::ptrdiff_t place, std::ptrdiff_t q, Vector<Real> e) {
  const Vector<Real> squared = most<Real>(Real{1} + e, every(no_length<Real>));
  const Vector<Real> s = e / (Real{1} + square_root<Real>(squared));
  const Vector<Real> s00 = load(data_.s00 + place);
  Vector<Real> alpha = every(data_.alpha);
  if constexpr (features.mixed) alpha = load(data_.alphas + place);
  const Vector<Real> s0 = most<Real>(s00 - alpha * s, every(Real{-1}));
  const Vector<Real> moved = select(above(every(unstretched<Real>), e), s0, s00);
  const Vector<Real> threshold = moved * (Real{2} + moved);
  store(data_.next_threshold + place, threshold);
  lower(scratch_.seen.row(1), q, threshold);
}

// Stores the data of a finished row of tiles for the next step, except differences.
template <KernelFeatures features>
void Sweep<features>::summarise(int tile_row) {
  for (int q = 0; q < columns_; q += NodeLayout::group) {
    TileRange<Real>& range =
        data_.next_range[data_.tiles.index(tile_row, (first_ + q) / NodeLayout::group)];
    Real threshold = unstretched<Real>;
    bool moving = was_moving(tile_row, q);
    for (int lane = 0; lane < NodeLayout::group; ++lane) {
      moving |= scratch_.seen.row(0)[q + lane] != 0;
      const Real own = scratch_.seen.row(1)[q + lane];
      threshold = own < threshold ? own : threshold;
    }
    range.moving = moving ? 1 : 0;
    if constexpr (features.history) range.min_threshold = threshold;
  }
}

template <KernelFeatures features>
void advance_rows(const KernelData<Real>& data, Scratch<Real>& scratch, Rows rows) {
  const FlushDenormals flush;
  const int groups = data.layout.groups(), most = scratch.columns / NodeLayout::group;
  const int blocks = (groups + most - 1) / most;
  for (int block = 0; block < blocks; ++block) {
    const int first = groups * block / blocks, end = groups * (block + 1) / blocks;
    Sweep<features>(data, scratch, rows, first * NodeLayout::group, end * NodeLayout::group).run();
  }
  if (data.ax == nullptr) survey_rows<Real>(data, rows);
}

template <KernelFeatures features>
Kernel<Real> with() {
  return {advance_rows<features>, survey_rows<Real>, join_rows<Real>};
}

template <bool mixed, bool heated>
Kernel<Real> with_materials(bool history) {
  return history ? with<KernelFeatures{true, true, true, mixed, heated}>()
                 : with<KernelFeatures{true, true, false, mixed, heated}>();
}

}  // namespace

template <>
Kernel<Real> kernel(KernelFeatures features) {
  if (features.mixed)
    return features.heated ? with_materials<true, true>(features.history)
                           : with_materials<true, false>(features.history);
  if (features.heated) return with_materials<false, true>(features.history);
  if (features.history)
    return features.guarded ? with<KernelFeatures{true, true, true}>()
                            : with<KernelFeatures{false, true, true}>();
  if (features.varied)
    return features.guarded ? with<KernelFeatures{true, true, false}>()
                            : with<KernelFeatures{false, true, false}>();
  return features.guarded ? with<KernelFeatures{true, false, false}>()
                          : with<KernelFeatures{false, false, false}>();
}

}  // namespace hackle::HACKLE_INSTRUCTION_SET
