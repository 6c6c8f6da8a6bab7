// SPDX-License-Identifier: MIT
// Derivatives of what nodes know, along a direction, never across a crack.
#pragma once

#include "solver/view.hpp"

namespace hackle {

// Along each axis the difference is central where intact bonds join a node to both neighbours, and
// of second order towards one side where they do not: exact for fields that are quadratic in x and
// y. 0 along an axis without a neighbour.
class Derivatives {
 public:
  // `direction` is a unit vector. The view must outlive it.
  Derivatives(const View& view, const Vec2& direction) : view_(&view), direction_(direction) {}

  // Returns the derivative at a node, per m, of value_of(i, j).
  template <class Value>
  Vec2 of(int i, int j, const Value& value_of) const {
    Vec2 sum(0, 0);
    if (direction_.x() != 0.0) sum += direction_.x() * along(i, j, 1, 0, value_of);
    if (direction_.y() != 0.0) sum += direction_.y() * along(i, j, 0, 1, value_of);
    return sum / view_->lattice().grid.dx;
  }

 private:
  bool joined(int i, int j, int column, int row) const {
    return view_->lattice().grid.contains(i + column, j + row) && view_->holds(i, j, column, row);
  }

  template <class Value>
  Vec2 along(int i, int j, int a, int b, const Value& value_of) const {
    const bool before = joined(i, j, -a, -b), behind = joined(i, j, a, b);
    if (before && behind)
      return 0.5 * (Vec2(value_of(i + a, j + b)) - Vec2(value_of(i - a, j - b)));
    if (behind) return to_one_side(i, j, a, b, value_of);
    if (before) return -to_one_side(i, j, -a, -b, value_of);
    return {0, 0};
  }

  template <class Value>
  Vec2 to_one_side(int i, int j, int a, int b, const Value& value_of) const {
    const Vec2 here = value_of(i, j), next = value_of(i + a, j + b);
    if (!joined(i + a, j + b, a, b)) return next - here;
    return -1.5 * here + 2.0 * next - 0.5 * Vec2(value_of(i + 2 * a, j + 2 * b));
  }

  const View* view_;
  Vec2 direction_;
};

}  // namespace hackle
