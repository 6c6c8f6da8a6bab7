// SPDX-License-Identifier: MIT
// Checks the ranges of any described noun.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/described.hpp"
#include "scene/amplitude.hpp"
#include "scene/field_of_place.hpp"
#include "scene/shape.hpp"

namespace hackle {

// Adds a problem for a number that is not finite or out of range, a vector that is not finite, a
// text that is none of its choices, or an invalid amplitude or region. Functions are not evaluated.
void check_value(double value, std::string_view who, std::string_view name, const About& about,
                 Problems& problems);
void check_value(const Vec2& value, std::string_view who, std::string_view name, const About& about,
                 Problems& problems);
inline void check_value(const VectorField& value, std::string_view who, std::string_view name,
                        const About& about, Problems& problems) {
  check_value(value.constant(), who, name, about, problems);
}
inline void check_value(const ScalarField& value, std::string_view who, std::string_view name,
                        const About& about, Problems& problems) {
  check_value(value.constant(), who, name, about, problems);
}
// Of a text that has choices; an empty one has not been given.
void check_value(const std::string& value, std::string_view who, std::string_view name,
                 const About& about, Problems& problems);
inline void check_value(const Amplitude& value, std::string_view who, std::string_view,
                        const About&, Problems& problems) {
  check(value, std::string(who), problems);
}
inline void check_value(const Shape& value, std::string_view who, std::string_view, const About&,
                        Problems& problems) {
  check(value, std::string(who), problems);
}

// Where T has a check_value(); an optional that holds nothing is right.
template <class T>
void check_given(const T& value, std::string_view who, std::string_view name, const About& about,
                 Problems& problems) {
  if constexpr (is_optional<T>) {
    if (value) check_given(*value, who, name, about, problems);
  } else if constexpr (std::is_integral_v<T>) {
    check_value(static_cast<double>(value), who, name, about, problems);
  } else if constexpr (requires { check_value(value, who, name, about, problems); }) {
    check_value(value, who, name, about, problems);
  }
}

// Returns whether an optional member has its default.
template <class T>
bool is_left_out(const T& value, const T& usual, const About& about) {
  if constexpr (std::is_same_v<T, double>) return !about.required && value == usual;
  return false;
}

// Checks every member that has a check_value(). An optional number that was left out is not held to
// its range.
template <Described Noun>
void check_members(const Noun& noun, std::string_view who, Problems& problems) {
  const Noun usual;
  const auto check_one = [&](const auto& value, const auto& left_out, std::string_view name,
                             const About& about) {
    if (!is_left_out(value, left_out, about)) check_given(value, who, name, about, problems);
  };
  for_each_member<Noun>([&](const auto& member) {
    if constexpr (requires { member.kind; }) {
      const auto kind = static_cast<std::size_t>(noun.*member.kind);
      check_one(noun.*member.pointer, usual.*member.pointer, member.names[kind],
                member.abouts[kind]);
    } else {
      check_one(noun.*member.pointer, usual.*member.pointer, member.name, member.about);
    }
  });
}

template <Described Noun>
void check_members(const Noun& noun, Problems& problems) {
  check_members(noun, description_of<Noun>.noun, problems);
}

}  // namespace hackle
