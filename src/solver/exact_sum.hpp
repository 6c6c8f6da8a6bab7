// SPDX-License-Identifier: MIT
// Sums that are rounded only once: they have the same bits in any order of the terms, and exactly
// the opposite value if every term changes its sign.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "scene/vec2.hpp"

namespace hackle {

// Requires finite terms with a finite sum (Shewchuk, Discrete Comput. Geom. 18 (1997) 305). Ten
// times slower than a plain sum; for one or two terms it is the plain sum.
class ExactSum {
 public:
  void add(double term) {
    std::size_t kept = 0;
    for (double part : parts_) {
      if (std::abs(term) < std::abs(part)) std::swap(term, part);
      const double high = term + part, low = part - (high - term);
      if (low != 0.0) parts_[kept++] = low;
      term = high;
    }
    parts_.resize(kept);
    parts_.push_back(term);
  }

  double value() const {
    if (parts_.empty()) return 0.0;
    std::size_t left = parts_.size() - 1;
    double high = parts_[left], low = 0.0;
    while (left > 0 && low == 0.0) {
      const double before = high, part = parts_[--left];
      high = before + part;
      low = part - (high - before);
    }
    return left > 0 ? to_nearest(high, low, parts_[left - 1]) : high;
  }

 private:
  // A tie is rounded according to the rest below it.
  static double to_nearest(double high, double low, double below) {
    if ((low < 0.0) != (below < 0.0)) return high;
    const double rounded = high + 2.0 * low;
    return rounded - high == 2.0 * low ? rounded : high;
  }

  std::vector<double> parts_;  // their sum is exact; smallest first, without overlaps
};

class ExactVectorSum {
 public:
  void add(const Vec2& term) {
    x_.add(term.x());
    y_.add(term.y());
  }
  Vec2 value() const { return {x_.value(), y_.value()}; }

 private:
  ExactSum x_, y_;
};

}  // namespace hackle
