// SPDX-License-Identifier: MIT
// The bonds of one class, a row of nodes at a time. Part of a kernel, see kernel_advance.cpp.
//
// Each bond is computed once, at the node that keeps it. Its force goes into the sum of that node
// and, through a row of its own, into that of the other end: reading the row shifted costs less
// than scattering. Sums are mirror-symmetric to the bit: the images of a class are added to each
// other first, bonds up and bonds down in two sums of the same order, and those on the row last
// (drawn in src/solver/README.md 4.1 and 4.2).
#pragma once

#include "solver/cpu/kernel_bond.hpp"
#include "solver/cpu/scratch.hpp"

namespace hackle::HACKLE_INSTRUCTION_SET {
namespace {

template <class Real>
struct Sums {
  Real* x;
  Real* y;
  Real* least;  // of e
};

template <class Real>
HACKLE_INLINE void add(Real* sum, std::ptrdiff_t q, Vector<Real> value) {
  store(sum + q, load(sum + q) + value);
}

template <class Real>
HACKLE_INLINE void lower(Real* sum, std::ptrdiff_t q, Vector<Real> value) {
  store(sum + q, least<Real>(load(sum + q), value));
}

template <class Real>
HACKLE_INLINE void keep(const Sums<Real>& to, std::ptrdiff_t q, const BondForce<Real>& force,
                        bool history) {
  store(to.x + q, force.x);
  store(to.y + q, force.y);
  if (history) store(to.least + q, force.e);
}

// The data for one row of the block.
template <class Real>
struct RowWork {
  KeptRow<Real> row;
  // of columns whose bonds are computed: the block, and those that reach into it
  const TileRun* runs;
  int run_count;
  int columns;  // of the block
  std::ptrdiff_t stride;
  Sums<Real> up;     // of the row itself
  Sums<Real> down;   // of the row that the class reaches
  Sums<Real> first;  // forces of the first image
  Sums<Real> second;
};

// The columns of a run, in whole vectors.
struct Columns {
  std::ptrdiff_t begin;
  std::ptrdiff_t end;
};

// Calls work<path>(columns) for every run that computes bonds, and rest(columns) for the others.
template <class Work, class Rest>
HACKLE_INLINE void for_runs(const TileRun* runs, int count, const Work& work, const Rest& rest) {
  for (int n = 0; n < count; ++n) {
    const Columns columns{runs[n].begin, runs[n].end};
    switch (runs[n].path) {
      case Path::intact:
        work.template operator()<Path::intact>(columns);
        break;
      case Path::damaged:
        work.template operator()<Path::damaged>(columns);
        break;
      case Path::careful:
        work.template operator()<Path::careful>(columns);
        break;
      case Path::still:
        rest(columns);
        break;
      case Path::linear:
        break;
    }
  }
}

// Calls work(q) for every vector of the block in a run that computes bonds.
template <class Real, class Work>
HACKLE_INLINE void for_sums(const RowWork<Real>& w, const Work& work) {
  for (int n = 0; n < w.run_count; ++n) {
    const TileRun& run = w.runs[n];
    if (run.path == Path::still || run.path == Path::linear) continue;
    const std::ptrdiff_t end = run.end < w.columns ? run.end : w.columns;
    for (std::ptrdiff_t q = run.begin > 0 ? run.begin : 0; q < end; q += lanes<Real>) work(q);
  }
}

// Computes the two kept images of a class, (+a, +b) and (-a, +b): adds both to the sum of their
// node, and keeps each for the other end.
template <class Real, KernelFeatures features, Path path>
__attribute__((noinline)) void keep_quads(const BondClass<Real>& class_, const RowWork<Real>& work,
                                          Columns columns) {
  const BondClass<Real> k = class_;
  const RowWork<Real> w = work;
  const std::ptrdiff_t right = k.rows * w.stride + k.columns, left = k.rows * w.stride - k.columns;
  for (std::ptrdiff_t q = columns.begin; q < columns.end; q += lanes<Real>) {
    const Vector<Real> x = load(w.row.ux + q), y = load(w.row.uy + q);
    const auto one =
        bond_force<Real, features, path, Span::quad>(k, w.row, k.a, x, y, q, right, k.bit);
    const auto two =
        bond_force<Real, features, path, Span::quad>(k, w.row, -k.a, x, y, q, left, k.bit << 1);
    keep(w.first, q, one, features.history);
    keep(w.second, q, two, features.history);
    add(w.up.x, q, one.x + two.x);
    add(w.up.y, q, one.y + two.y);
    if constexpr (features.history) lower(w.up.least, q, least<Real>(one.e, two.e));
  }
}

template <class Real, KernelFeatures features>
HACKLE_INLINE void add_quads(const BondClass<Real>& k, const RowWork<Real>& w) {
  for_runs(
      w.runs, w.run_count,
      [&]<Path path>(Columns columns) { keep_quads<Real, features, path>(k, w, columns); },
      [&](Columns columns) {
        for (std::ptrdiff_t q = columns.begin; q < columns.end; q += lanes<Real>) {
          keep(w.first, q, BondForce<Real>{}, features.history);
          keep(w.second, q, BondForce<Real>{}, features.history);
          if constexpr (features.history) lower(w.up.least, q, Vector<Real>{});
        }
      });
  const std::ptrdiff_t a = k.columns;
  for_sums(w, [&](std::ptrdiff_t q) HACKLE_LAMBDA_INLINE {
    add(w.down.x, q, load(w.second.x + q + a) + load(w.first.x + q - a));
    add(w.down.y, q, load(w.second.y + q + a) + load(w.first.y + q - a));
    if constexpr (features.history)
      lower(w.down.least, q,
            least<Real>(load(w.second.least + q + a), load(w.first.least + q - a)));
  });
}

// Classes (0, +b), whose ends are in one column.
template <class Real, KernelFeatures features, Path path>
__attribute__((noinline)) void keep_column(const BondClass<Real>& class_, const RowWork<Real>& work,
                                           Columns columns) {
  const BondClass<Real> k = class_;
  const RowWork<Real> w = work;
  const std::ptrdiff_t up = k.rows * w.stride;
  for (std::ptrdiff_t q = columns.begin; q < columns.end; q += lanes<Real>) {
    const Vector<Real> x = load(w.row.ux + q), y = load(w.row.uy + q);
    const auto force =
        bond_force<Real, features, path, Span::column>(k, w.row, Real{0}, x, y, q, up, k.bit);
    add(w.up.x, q, force.x);
    add(w.up.y, q, force.y);
    add(w.down.x, q, force.x);
    add(w.down.y, q, force.y);
    if constexpr (features.history) {
      lower(w.up.least, q, force.e);
      lower(w.down.least, q, force.e);
    }
  }
}

template <class Real, KernelFeatures features>
HACKLE_INLINE void add_columns(const BondClass<Real>& k, const RowWork<Real>& w) {
  for_runs(
      w.runs, w.run_count,
      [&]<Path path>(Columns columns) { keep_column<Real, features, path>(k, w, columns); },
      [&](Columns columns) {
        if constexpr (features.history)
          for (std::ptrdiff_t q = columns.begin; q < columns.end; q += lanes<Real>) {
            lower(w.up.least, q, Vector<Real>{});
            lower(w.down.least, q, Vector<Real>{});
          }
      });
}

// Classes (+a, 0).
template <class Real, KernelFeatures features, Path path>
__attribute__((noinline)) void keep_row(const BondClass<Real>& class_, const RowWork<Real>& work,
                                        Columns columns) {
  const BondClass<Real> k = class_;
  const RowWork<Real> w = work;
  for (std::ptrdiff_t q = columns.begin; q < columns.end; q += lanes<Real>) {
    const Vector<Real> x = load(w.row.ux + q), y = load(w.row.uy + q);
    keep(w.first, q,
         bond_force<Real, features, path, Span::row>(k, w.row, k.a, x, y, q, k.columns, k.bit),
         features.history);
  }
}

// Adds the forces on both ends to the sum of the row.
template <class Real, KernelFeatures features>
HACKLE_INLINE void add_row(const BondClass<Real>& k, const RowWork<Real>& w) {
  for_runs(
      w.runs, w.run_count,
      [&]<Path path>(Columns columns) { keep_row<Real, features, path>(k, w, columns); },
      [&](Columns columns) {
        for (std::ptrdiff_t q = columns.begin; q < columns.end; q += lanes<Real>)
          keep(w.first, q, BondForce<Real>{}, features.history);
      });
  const std::ptrdiff_t a = k.columns;
  for_sums(w, [&](std::ptrdiff_t q) HACKLE_LAMBDA_INLINE {
    add(w.up.x, q, load(w.first.x + q) - load(w.first.x + q - a));
    add(w.up.y, q, load(w.first.y + q) - load(w.first.y + q - a));
    if constexpr (features.history)
      lower(w.up.least, q, least<Real>(load(w.first.least + q), load(w.first.least + q - a)));
  });
}

}  // namespace
}  // namespace hackle::HACKLE_INSTRUCTION_SET
