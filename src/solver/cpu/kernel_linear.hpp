// SPDX-License-Identifier: MIT
// The linearised force, K (xi.h) xi/L^2, of whole families as a stencil. Part of a kernel, see
// kernel_advance.cpp.
//
// The four images of an offset differ in signs alone, so rows are combined first, by columns, and
// columns after: with S = u(j+b) + u(j-b) and T = u(j+b) - u(j-b),
//   F_x(i) = sum_a P_a(i+a) + P_a(i-a) + Q_a(i+a) - Q_a(i-a) - w u_x(i),
//   P_a = sum_b K a^2/L^2 S_b of u_x and Q_a = sum_b K a b/L^2 T_b of u_y,
// and F_y likewise. Every mirror exchanges terms of commutative sums: symmetric to the bit.
#pragma once

#include "solver/cpu/kernel_rows.hpp"

namespace hackle::HACKLE_INSTRUCTION_SET {
namespace {

// Sums over the rows of one column of nodes, for all column offsets a: 4 a + 0..3.
template <class Real>
struct ColumnSums {
  ScratchRows<Real>& rows;
  Real* px(int a) const { return rows.row(4 * a); }
  Real* py(int a) const { return rows.row(4 * a + 1); }
  Real* qx(int a) const { return rows.row(4 * a + 2); }
  Real* qy(int a) const { return rows.row(4 * a + 3); }
};

// Computes the sums of the column offset a for one vector of columns. `reach` is that of the family
// if it is known at compile time: the compiler then keeps everything in registers and omits
// vanishing terms; otherwise 0.
template <class Real, int reach>
__attribute__((noinline)) void fold_rows(const LinearStencil<Real>& stencil, const RowWork<Real>& w,
                                         const ColumnSums<Real>& sums, Columns columns) {
  constexpr int most = reach > 0 ? reach : NodeLayout::group;
  const int last = reach > 0 ? reach : stencil.reach;
  const auto in_family = [&](int a, int b) HACKLE_LAMBDA_INLINE {
    return reach > 0 ? a * a + b * b <= reach * reach : b <= stencil.max_rows[a];
  };
  for (std::ptrdiff_t q = columns.begin; q < columns.end; q += lanes<Real>) {
    Vector<Real> sx[most + 1], sy[most + 1], tx[most + 1], ty[most + 1];
    sx[0] = load(w.row.ux + q);
    sy[0] = load(w.row.uy + q);
#pragma GCC unroll 9
    for (int b = 1; b <= last; ++b) {
      const std::ptrdiff_t above = q + b * w.stride, below = q - b * w.stride;
      const Vector<Real> ax = load(w.row.ux + above), bx = load(w.row.ux + below);
      const Vector<Real> ay = load(w.row.uy + above), by = load(w.row.uy + below);
      sx[b] = ax + bx;
      sy[b] = ay + by;
      tx[b] = ax - bx;
      ty[b] = ay - by;
    }
#pragma GCC unroll 9
    for (int a = 0; a <= last; ++a) {
      Vector<Real> px{}, py{}, qx{}, qy{};
#pragma GCC unroll 9
      for (int b = last; b >= 0; --b) {
        if (!in_family(a, b)) continue;
        const LinearWeight<Real>& weight = stencil.weights[a][b];
        if (a > 0) px = multiply_add<Real>(sx[b], every(weight.xx), px);
        if (b > 0) py = multiply_add<Real>(sy[b], every(weight.yy), py);
        if (a > 0 && b > 0) qx = multiply_add<Real>(ty[b], every(weight.xy), qx);
        if (a > 0 && b > 0) qy = multiply_add<Real>(tx[b], every(weight.xy), qy);
      }
      if (a > 0) store(sums.px(a) + q, px);
      store(sums.py(a) + q, py);
      if (a > 0) store(sums.qx(a) + q, qx);
      if (a > 0) store(sums.qy(a) + q, qy);
    }
  }
}

template <class Real>
__attribute__((noinline)) void fold_columns(const LinearStencil<Real>& stencil,
                                            const RowWork<Real>& w, const ColumnSums<Real>& sums,
                                            Columns columns) {
  for (std::ptrdiff_t q = columns.begin; q < columns.end; q += lanes<Real>) {
    Vector<Real> x{}, y{};
    for (int a = stencil.reach; a >= 1; --a) {
      x += (load(sums.px(a) + q + a) + load(sums.px(a) + q - a)) +
           (load(sums.qx(a) + q + a) - load(sums.qx(a) + q - a));
      y += (load(sums.py(a) + q + a) + load(sums.py(a) + q - a)) +
           (load(sums.qy(a) + q + a) - load(sums.qy(a) + q - a));
    }
    y += load(sums.py(0) + q);
    store(w.up.x + q, x - stencil.own_x * load(w.row.ux + q));
    store(w.up.y + q, y - stencil.own_y * load(w.row.uy + q));
  }
}

// Writes the linearised force of the columns of a row, whose families must be complete.
template <class Real>
HACKLE_INLINE void linear_row(const LinearStencil<Real>& stencil, const RowWork<Real>& w,
                              ScratchRows<Real>& rows, Columns columns) {
  const ColumnSums<Real> sums{rows};
  const int margin = (stencil.reach + lanes<Real> - 1) / lanes<Real> * lanes<Real>;
  const Columns wide{columns.begin - margin, columns.end + margin};
  switch (stencil.round ? stencil.reach : 0) {
    case 2:
      fold_rows<Real, 2>(stencil, w, sums, wide);
      break;
    case 3:
      fold_rows<Real, 3>(stencil, w, sums, wide);
      break;
    case 4:
      fold_rows<Real, 4>(stencil, w, sums, wide);
      break;
    case 5:
      fold_rows<Real, 5>(stencil, w, sums, wide);
      break;
    case 6:
      fold_rows<Real, 6>(stencil, w, sums, wide);
      break;
    default:
      fold_rows<Real, 0>(stencil, w, sums, wide);
      break;
  }
  fold_columns(stencil, w, sums, columns);
}

}  // namespace
}  // namespace hackle::HACKLE_INSTRUCTION_SET
