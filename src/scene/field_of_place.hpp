// SPDX-License-Identifier: MIT
// A quantity over the plate as the user gives it: constant, or a function of place, or of place and
// time.
#pragma once

#include <functional>
#include <type_traits>
#include <utility>

#include "scene/vec2.hpp"

namespace hackle {

template <class T>
class FieldOfPlace {
 public:
  FieldOfPlace() = default;
  FieldOfPlace(T constant) : constant_(std::move(constant)) {}
  FieldOfPlace(double x, double y) requires std::is_same_v<T, Vec2> : constant_(x, y) {}
  // Calls `function` with a point of the plate, in m. It may throw Error.
  explicit FieldOfPlace(std::function<T(const Vec2&)> function) : function_(std::move(function)) {}
  // Calls `course` also with a time, s.
  explicit FieldOfPlace(std::function<T(const Vec2&, double)> course)
      : course_(std::move(course)) {}

  bool is_constant() const { return !function_ && !course_; }
  bool varies_in_time() const { return static_cast<bool>(course_); }
  const T& constant() const { return constant_; }
  // Of the same constant; a function is equal to none.
  friend bool operator==(const FieldOfPlace& one, const FieldOfPlace& other) {
    return one.is_constant() && other.is_constant() && one.constant_ == other.constant_;
  }
  T at(const Vec2& point, double t = 0.0) const {
    if (course_) return course_(point, t);
    return function_ ? function_(point) : constant_;
  }

 private:
  static T zero() {
    if constexpr (std::is_arithmetic_v<T>)
      return T(0);
    else
      return T::Zero();  // T{} of an Eigen type is uninitialised
  }

  T constant_ = zero();
  std::function<T(const Vec2&)> function_;
  std::function<T(const Vec2&, double)> course_;
};

using VectorField = FieldOfPlace<Vec2>;
using ScalarField = FieldOfPlace<double>;

}  // namespace hackle
