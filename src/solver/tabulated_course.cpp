// SPDX-License-Identifier: MIT
#include "solver/tabulated_course.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "base/error.hpp"

namespace hackle {
namespace {

double magnitude(double value) {
  return std::abs(value);
}
double magnitude(const Vec2& value) {
  return value.norm();
}

// Returns the step at which the block of a step begins.
std::int64_t beginning_of(std::int64_t step, const Clock& clock, std::int64_t steps) {
  const std::int64_t past = (step - clock.since) % steps;
  return step - (past < 0 ? past + steps : past);
}

template <class T>
T between(const T& one, const T& other, double share) {
  return (1.0 - share) * one + share * other;
}

// The first moment of a block that is not before a step.
template <class Moments>
auto find_moment(Moments& moments, std::int64_t step) {
  return std::ranges::lower_bound(moments, step, {},
                                  [](const auto& moment) { return moment.step; });
}

[[noreturn]] void refuse_table(const std::string& who, std::int64_t steps, std::size_t nodes,
                               std::size_t bytes) {
  throw Error(
      ErrorKind::refused,
      fmt::format("{}: its function of place and time would take more than {} MB, tabulated "
                  "for {} steps at {} nodes",
                  who, bytes >> 20, steps, nodes),
      "run in pieces, or give a function of place and an amplitude in time");
}

}  // namespace

template <class T>
void TabulatedCourse<T>::tabulate(const Clock& clock, std::int64_t begin, std::int64_t end,
                                  double dt) {
  if (empty() || begin >= end) return;
  keep_those_of(clock, dt);
  std::erase_if(blocks_, [&](const Block& block) {
    return block.first + steps <= begin || block.first >= end;
  });
  for (std::int64_t first = beginning_of(begin, clock, steps); first < end; first += steps) {
    block_from(first);
    if (bytes() > max_bytes)
      refuse_table(course_.who, end - begin, course_.places.size(), max_bytes);
  }
}

template <class T>
std::vector<T> TabulatedCourse<T>::at(const Clock& clock, std::int64_t step, double dt) {
  keep_those_of(clock, dt);
  if (bytes() > max_bytes) blocks_.clear();
  const std::int64_t first = beginning_of(step, clock, steps);
  // Before a run only the present is asked for, which is a moment of the table to come.
  if (step == first && blocks_.empty()) return values_at(course_, clock.time(step, shift_, dt));
  const Block& block = block_from(first);
  const std::int64_t past = step - block.first;
  const auto next = find_moment(block.moments, past);
  if (next->step == past) return next->values;
  const auto before = std::prev(next);
  const double share =
      static_cast<double>(past - before->step) / static_cast<double>(next->step - before->step);
  std::vector<T> values;
  values.reserve(next->values.size());
  for (std::size_t k = 0; k < next->values.size(); ++k)
    values.push_back(between(before->values[k], next->values[k], share));
  return values;
}

template <class T>
void TabulatedCourse<T>::keep_those_of(const Clock& clock, double dt) {
  if (clock == clock_ && dt == dt_) return;
  blocks_.clear();
  clock_ = clock;
  dt_ = dt;
}

template <class T>
const typename TabulatedCourse<T>::Block& TabulatedCourse<T>::block_from(std::int64_t first) {
  const auto found = std::ranges::lower_bound(blocks_, first, {}, &Block::first);
  if (found != blocks_.end() && found->first == first) return *found;
  Block block{first, 0.0, {}};
  for (std::int64_t step = 0; step <= steps; step += gap) add(block, step);
  for (std::int64_t step = 0; step < steps; step += gap) refine(block, step, step + gap);
  return *blocks_.insert(found, std::move(block));
}

template <class T>
void TabulatedCourse<T>::add(Block& block, std::int64_t step) const {
  Moment moment{step, values_at(course_, clock_.time(block.first + step, shift_, dt_))};
  for (const T& value : moment.values) block.largest = std::max(block.largest, magnitude(value));
  block.moments.insert(find_moment(block.moments, step), std::move(moment));
}

template <class T>
void TabulatedCourse<T>::refine(Block& block, std::int64_t from, std::int64_t to) const {
  const std::int64_t middle = (from + to) / 2;
  if (middle == from) return;
  add(block, middle);
  const auto at = find_moment(block.moments, middle);
  double error = 0.0;
  for (std::size_t k = 0; k < at->values.size(); ++k) {
    const T line = between(std::prev(at)->values[k], std::next(at)->values[k], 0.5);
    error = std::max(error, magnitude(T(at->values[k] - line)));
  }
  if (!(error > max_error * block.largest)) return;
  refine(block, from, middle);
  refine(block, middle, to);
}

template <class T>
std::size_t TabulatedCourse<T>::moments() const {
  std::size_t sum = 0;
  for (const Block& block : blocks_) sum += block.moments.size();
  return sum;
}

template <class T>
std::size_t TabulatedCourse<T>::bytes() const {
  return moments() * course_.places.size() * sizeof(T);
}

template class TabulatedCourse<double>;
template class TabulatedCourse<Vec2>;

}  // namespace hackle
