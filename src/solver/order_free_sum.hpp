// SPDX-License-Identifier: MIT
// Sums that do not depend on the order of their terms, so that neither threads nor mirror images
// change a bit.
#pragma once

#include <cmath>
#include <cstdint>

#include "scene/vec2.hpp"

namespace hackle {

// A vector in fixed point: terms are rounded to multiples of 2^-44, 6e-14, and may add up to 5e5.
// Intended for accelerations in lattice units, which are far below 1.
class OrderFreeSum {
 public:
  void add(const Vec2& term) {
    x_ += std::llround(term.x() * one);
    y_ += std::llround(term.y() * one);
  }
  void subtract(const Vec2& term) { add(-term); }
  Vec2 value() const { return {static_cast<double>(x_) / one, static_cast<double>(y_) / one}; }
  bool is_zero() const { return x_ == 0 && y_ == 0; }

 private:
  static constexpr double one = 0x1p44;

  std::int64_t x_ = 0;
  std::int64_t y_ = 0;
};

}  // namespace hackle
