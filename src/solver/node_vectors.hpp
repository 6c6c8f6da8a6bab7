// SPDX-License-Identifier: MIT
// A vector per node, in double precision: displacements, forces, and the vectors of a linear
// solver. Sums are the same for any number of threads, and for mirror images.
#pragma once

#include <cstddef>
#include <span>

#include "lattice/node_layout.hpp"
#include "solver/threads.hpp"
#include "solver/values.hpp"

namespace hackle {

// Places are those of a NodeLayout; ghosts are 0.
struct NodeVectors {
  NodeVectors() = default;
  explicit NodeVectors(const NodeLayout& layout) : x(layout.size()), y(layout.size()) {}

  Values<double> x, y;
};

// Computes the sum of term(0) to term(count - 1), which is the same to the bit in reversed order.
template <class Term>
double paired_sum(int count, const Term& term) {
  double sum = 0.0;
  for (int k = 0; k < count / 2; ++k) sum += term(k) + term(count - 1 - k);
  return count % 2 == 1 ? sum + term(count / 2) : sum;
}

// Calls work(j) for every row, several rows per task.
template <class Work>
void for_rows(const Threads& threads, int rows, const Work& work) {
  constexpr int per_task = 8;
  threads.for_tasks((rows + per_task - 1) / per_task, [&](int task, int) {
    for (int j = task * per_task; j < rows && j < (task + 1) * per_task; ++j) work(j);
  });
}

// Computes a . b of row j.
double dot_of_row(const NodeLayout& layout, const NodeVectors& a, const NodeVectors& b, int j);
// Returns the largest length of a vector in row j.
double largest_of_row(const NodeLayout& layout, const NodeVectors& a, int j);

// Returns the sum of the values of rows.
double sum_of_rows(std::span<const double> of_row);
double max_of_rows(std::span<const double> of_row);

}  // namespace hackle
