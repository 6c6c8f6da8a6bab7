// SPDX-License-Identifier: MIT
// The force of bonds, a vector of nodes at a time. Part of a kernel, see kernel_advance.cpp.
#pragma once

#include "solver/cpu/kernel.hpp"
#include "solver/cpu/simd.hpp"

namespace hackle::HACKLE_INSTRUCTION_SET {
namespace {

// A row of nodes with kept bonds; pointers to column 0 of the block.
template <class Real>
struct KeptRow {
  const Real* ux;
  const Real* uy;
  const std::uint32_t* bonds;
  const std::uint32_t* unbreakable;
  const Real* threshold;
  const Real* half_stiffness;
  const Real* heat;
  std::ptrdiff_t place;  // of column 0 of the block
  void* broken_bonds;    // null: breaking is not recorded
  bool late;             // overstretched bonds still exert their force
};

void note_broken_bonds(void* broken_bonds, std::ptrdiff_t at, int word, std::uint32_t bit);

template <class Real>
struct BondForce {
  Vector<Real> x, y;
  Vector<Real> e;  // if requested; `unstretched` for a broken bond
};

// Larger than every stretch: the e of a broken bond, so that it is never the smallest of a node.
template <class Real>
inline constexpr Real unstretched = static_cast<Real>(1e30);

// The smallest squared length ratio: coinciding nodes must not divide by zero.
template <class Real>
inline constexpr Real no_length = static_cast<Real>(1e-12);

// Computes K g(e) from E by the series.
template <class Real>
HACKLE_INLINE Vector<Real> series(const BondClass<Real>& k, Vector<Real> E) {
  Vector<Real> sum = every(k.series[series_terms<Real> - 1]);
  for (int term = series_terms<Real> - 2; term >= 0; --term)
    sum = multiply_add<Real>(sum, E, every(k.series[term]));
  return sum * E;
}

// Computes K g(e) for every E: g(e) = e/((1+e) + sqrt(1+e)), free of cancellation.
template <class Real>
HACKLE_INLINE Vector<Real> exact(const BondClass<Real>& k, Vector<Real> E) {
  const Vector<Real> e = E * k.inverse_L2;
  const Vector<Real> squared = most<Real>(Real{1} + e, every(no_length<Real>));
  return k.pull * (e / (squared + square_root<Real>(squared)));
}

// Returns the lanes whose bond is overstretched, or beyond the range of the series.
template <class Real, KernelFeatures features>
HACKLE_INLINE Mask<Real> suspicious(const BondClass<Real>& k, const KeptRow<Real>& row,
                                    Vector<Real> E, std::ptrdiff_t q, std::ptrdiff_t to) {
  Vector<Real> limit = every(k.sure);
  if constexpr (features.varied)
    limit = least<Real>(limit,
                        k.L2 * least<Real>(load(row.threshold + q), load(row.threshold + q + to)));
  return above(magnitude<Real>(E), limit);
}

// Settles the suspicious lanes, which are rare: takes the exact pull beyond the series, and records
// the bonds that break. Takes these out of `held`, unless breaking is late.
template <class Real, KernelFeatures features>
__attribute__((noinline)) void settle(const BondClass<Real>& k, const KeptRow<Real>& row,
                                      std::ptrdiff_t q, std::ptrdiff_t to, std::uint32_t bit,
                                      const Vector<Real>& E, Mask<Real>& held, Vector<Real>& pull) {
  pull = select(above(magnitude<Real>(E), every(k.range)), exact(k, E), pull);
  Mask<Real> over = above(E, every(k.most));
  if constexpr (features.varied)
    over =
        above(E * k.inverse_L2, least<Real>(load(row.threshold + q), load(row.threshold + q + to)));
  over = over & held;
  if constexpr (features.guarded)
    if (!(features.mixed || features.heated) || row.unbreakable != nullptr)
      over = over.but_not(load_bit<Real>(row.unbreakable + q, bit));
  if (!row.late) held = held.but_not(over);
  if (row.broken_bonds == nullptr) return;
  for (int lane = 0; lane < lanes<Real>; ++lane)
    if (over[lane]) note_broken_bonds(row.broken_bonds, row.place + q + lane, k.word, bit);
}

// The relative position of the two ends of a bond.
enum class Span { quad, column, row };

// Computes the force of the bonds that the nodes from column q keep to the nodes `to` places away.
// `a` carries the sign of the image. Both ends of a bond use this one result, so they agree to the
// last bit; it is exactly the mirror image of the result of the mirrored bond
// (src/solver/README.md 4.2).
template <class Real, KernelFeatures features, Path path, Span span>
HACKLE_INLINE BondForce<Real> bond_force(const BondClass<Real>& k, const KeptRow<Real>& row, Real a,
                                         Vector<Real> x, Vector<Real> y, std::ptrdiff_t q,
                                         std::ptrdiff_t to, std::uint32_t bit) {
  const Vector<Real> hx = load(row.ux + q + to) - x, hy = load(row.uy + q + to) - y;
  Vector<Real> px = hx, py = hy, tx = hx, ty = hy;  // xi + h and 2 xi + h
  if constexpr (span != Span::column) px = hx + a, tx = hx + (a + a);
  if constexpr (span != Span::row) py = hy + k.b, ty = hy + (k.b + k.b);
  Vector<Real> E = multiply_add<Real>(hx, tx, hy * ty);
  if constexpr (features.heated)
    E = multiply_add<Real>(load(row.heat + q) + load(row.heat + q + to), every(-k.L2), E);
  Vector<Real> pull = series(k, E);
  BondForce<Real> force;
  if constexpr (features.history) force.e = E * k.inverse_L2;
  if constexpr (path != Path::intact) {
    Mask<Real> held = load_bit<Real>(row.bonds + q, bit);
    if constexpr (path == Path::careful)
      if ((suspicious<Real, features>(k, row, E, q, to) & held).any()) [[unlikely]]
        settle<Real, features>(k, row, q, to, bit, E, held, pull);
    pull = select(held, pull, Vector<Real>{});
    if constexpr (features.history) force.e = select(held, force.e, every(unstretched<Real>));
  }
  if constexpr (features.mixed)
    pull *= load(row.half_stiffness + q) + load(row.half_stiffness + q + to);
  force.x = pull * px;
  force.y = pull * py;
  return force;
}

}  // namespace
}  // namespace hackle::HACKLE_INSTRUCTION_SET
