// SPDX-License-Identifier: MIT
#include "solver/node_vectors.hpp"

#include <algorithm>
#include <cmath>

namespace hackle {

double dot_of_row(const NodeLayout& layout, const NodeVectors& a, const NodeVectors& b, int j) {
  const auto first = static_cast<std::size_t>(layout.at(0, j));
  const double *ax = &a.x[first], *ay = &a.y[first], *bx = &b.x[first], *by = &b.y[first];
  return paired_sum(layout.nx, [=](int i) { return ax[i] * bx[i] + ay[i] * by[i]; });
}

double largest_of_row(const NodeLayout& layout, const NodeVectors& a, int j) {
  const auto first = static_cast<std::size_t>(layout.at(0, j));
  const double *x = &a.x[first], *y = &a.y[first];
  double max = 0.0;
  for (int i = 0; i < layout.nx; ++i) {
    const double squared = x[i] * x[i] + y[i] * y[i];
    if (!(squared <= max)) max = squared;  // nan stays
  }
  return std::sqrt(max);
}

double sum_of_rows(std::span<const double> of_row) {
  return paired_sum(static_cast<int>(of_row.size()),
                    [&](int j) { return of_row[static_cast<std::size_t>(j)]; });
}

double max_of_rows(std::span<const double> of_row) {
  double max = 0.0;
  for (const double value : of_row)
    if (!(value <= max)) max = value;
  return max;
}

}  // namespace hackle
