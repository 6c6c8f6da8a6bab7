// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "lattice/load_map.hpp"
#include "solver/clock.hpp"

namespace hackle {

// A quantity of nodes as a function of place and time (see Course), at the steps of a run. Its
// function is asked at moments of a block of steps, and values between two moments are interpolated
// linearly. Moments are added until halfway between two of them the error is below max_error of the
// largest value in the block, or until each step has its own. Blocks are counted from the first
// step of the clock, so values do not depend on how a run is cut into parts.
template <class T>
class TabulatedCourse {
 public:
  static constexpr std::int64_t steps = 64;  // of a block
  static constexpr std::int64_t gap = 16;    // steps between the first moments
  static constexpr double max_error = 1e-3;
  static constexpr std::size_t max_bytes = std::size_t{1} << 29;

  // In a step the values are those at the time when the share `shift` of the step has passed.
  TabulatedCourse(Course<T> course, double shift) : course_(std::move(course)), shift_(shift) {}

  bool empty() const { return course_.empty(); }
  const Course<T>& course() const { return course_; }
  // Asks the function for the steps begin <= n < end, so that at() need not. Throws what
  // values_at() throws, and Error (refused) if the table would take more than max_bytes.
  void tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double dt);
  // Returns the values of all nodes in a step. Throws what values_at() throws.
  std::vector<T> at(const Clock& clock, std::int64_t step, double dt);
  std::size_t bytes() const;
  // Returns how often each node was asked for what is kept.
  std::size_t moments() const;

 private:
  struct Moment {
    std::int64_t step = 0;  // from the beginning of the block
    std::vector<T> values;
  };
  struct Block {
    std::int64_t first = 0;  // step
    double largest = 0.0;    // magnitude
    std::vector<Moment> moments;
  };

  // Forgets the blocks of another clock or step.
  void keep_those_of(const Clock& clock, double dt);
  const Block& block_from(std::int64_t first);
  void add(Block& block, std::int64_t step) const;
  void refine(Block& block, std::int64_t from, std::int64_t to) const;

  Course<T> course_;
  double shift_;
  Clock clock_;  // of the blocks, as dt_
  double dt_ = 0.0;
  std::vector<Block> blocks_;  // in the order of their steps
};

}  // namespace hackle
