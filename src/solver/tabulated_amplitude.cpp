// SPDX-License-Identifier: MIT
#include "solver/tabulated_amplitude.hpp"

#include <iterator>

#include <fmt/format.h>

#include "base/error.hpp"

namespace hackle {
namespace {

constexpr std::int64_t max_tabulated = 100'000'000;

}  // namespace

void TabulatedAmplitude::tabulate(const Clock& clock, std::int64_t begin, std::int64_t end,
                                  double dt) {
  if (!amplitude_.is_function() || begin >= end) return;
  if (end - begin > max_tabulated)
    throw Error(ErrorKind::refused,
                fmt::format("run: a function of time would be asked for {:.3g} steps beforehand, "
                            "{:.0e} are the most",
                            static_cast<double>(end - begin), static_cast<double>(max_tabulated)),
                "run in pieces, or give a table of times and factors");
  clock_ = clock;
  first_ = begin;
  table_.clear();
  table_.reserve(static_cast<std::size_t>(end - begin));
  for (std::int64_t step = begin; step < end; ++step) table_.push_back(evaluate(clock, step, dt));
}

double TabulatedAmplitude::at(const Clock& clock, std::int64_t step, double dt) const {
  const std::int64_t place = step - first_;
  if (place >= 0 && place < std::ssize(table_) && clock == clock_)
    return table_[static_cast<std::size_t>(place)];
  return evaluate(clock, step, dt);
}

}  // namespace hackle
