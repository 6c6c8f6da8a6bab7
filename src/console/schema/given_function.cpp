// SPDX-License-Identifier: MIT
#include "console/schema/given_function.hpp"

#include <array>
#include <functional>
#include <span>
#include <string>
#include <type_traits>

#include <fmt/format.h>

#include "base/units.hpp"
#include "scene/vec2.hpp"

namespace hackle {
namespace {

std::string at_place(const Vec2& place) {
  return fmt::format("at x = {}, y = {}", quantity(place.x(), "m"), quantity(place.y(), "m"));
}

template <class T>
T called(const LuaFunction& function, std::span<const double> arguments, const std::string& where) {
  T value{};
  if constexpr (std::is_same_v<T, double>)
    function.call(arguments, {&value, 1}, where);
  else
    function.call(arguments, {value.data(), 2}, where);
  return value;
}

}  // namespace

template <class T>
FieldOfPlace<T> field_of(const LuaFunction& function) {
  if (function.parameters() < 3)
    return FieldOfPlace<T>(std::function<T(const Vec2&)>([function](const Vec2& place) {
      return called<T>(function, {place.data(), 2}, at_place(place));
    }));
  return FieldOfPlace<T>(
      std::function<T(const Vec2&, double)>([function](const Vec2& place, double t) {
        return called<T>(function, std::array{place.x(), place.y(), t},
                         fmt::format("{}, t = {}", at_place(place), quantity(t, "s")));
      }));
}

template FieldOfPlace<double> field_of(const LuaFunction& function);
template FieldOfPlace<Vec2> field_of(const LuaFunction& function);

Amplitude amplitude_of(const LuaFunction& function) {
  return Amplitude(
      [function](double t) {
        double factor = 0.0;
        function.call({&t, 1}, {&factor, 1}, fmt::format("at t = {}", quantity(t, "s")));
        return factor;
      },
      function.text());
}

}  // namespace hackle
