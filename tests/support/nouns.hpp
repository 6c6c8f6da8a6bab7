// SPDX-License-Identifier: MIT
// Nouns of any kind, filled from their descriptions: no two members have the same value, and none
// is out of its range.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "base/described.hpp"
#include "scene/amplitude.hpp"
#include "scene/field_of_place.hpp"
#include "scene/shape.hpp"

namespace hackle::test {

struct Everything {
  template <class T>
  constexpr bool operator()(T) const {
    return true;
  }
};

class NounFiller {
 public:
  // Another seed gives other values.
  explicit NounFiller(int seed) : count_(seed) {}

  // Fills the members whose std::type_identity Takes() takes.
  template <class Takes, Described Noun>
  void fill_members(Noun& noun) {
    for_each_member<Noun>([&](const auto& member) {
      auto& value = noun.*member.pointer;
      using T = std::remove_cvref_t<decltype(value)>;
      if constexpr (requires { member.kind; }) {
        using Kind = std::remove_cvref_t<decltype(noun.*member.kind)>;
        const std::size_t kind = next() % member.names.size();
        noun.*member.kind = static_cast<Kind>(kind);
        fill(value, member.abouts[kind]);
      } else if constexpr (Takes()(std::type_identity<T>())) {
        fill(value, member.about);
      } else if constexpr (Described<T>) {
        if (member.name.empty()) fill_members<Takes>(value);
      }
    });
  }

  template <class T>
  void fill(T& value, const About& about) {
    if constexpr (is_optional<T>) {
      fill(value.emplace(), about);
    } else if constexpr (std::is_same_v<T, Bitmap>) {
      value = {{number({}), 0.1}, {0.2, number({})}, 3, 2, {0, 1, 1, 1, 0, 1}};
    } else if constexpr (Described<T>) {
      fill_members<Everything>(value);
    } else if constexpr (std::is_same_v<T, Shape>) {
      fill_shape(value);
    } else if constexpr (is_list<T>) {
      const double min = std::isfinite(about.range.min) ? about.range.min : 1.0;
      value.resize(static_cast<std::size_t>(min) + next() % 3);
      for (auto& entry : value) fill(entry, {});
    } else {
      fill_value(value, about);
    }
  }

 private:
  std::size_t next() { return static_cast<std::size_t>(++count_); }

  double number(const Range& range) {
    const double share = std::fmod(0.6180339887 * static_cast<double>(next()), 1.0);
    const double width = std::isfinite(range.max - range.min) ? range.max - range.min : 1e3;
    if (std::isfinite(range.min)) return range.min + (0.01 + 0.98 * share) * width;
    return (std::isfinite(range.max) ? range.max : 500.0) - (0.01 + 0.98 * share) * width;
  }

  template <class T>
  void fill_value(T& value, const About& about) {
    if constexpr (std::is_same_v<T, bool>)
      value = next() % 2 == 0;
    else if constexpr (std::is_enum_v<T>)
      value = static_cast<T>(next() % enum_names<T>.size());
    else if constexpr (std::is_integral_v<T>)
      value = static_cast<T>(std::floor(number(about.range)));
    else if constexpr (std::is_same_v<T, double>)
      value = number(about.range);
    else if constexpr (std::is_same_v<T, std::string>)
      value = about.choices.empty()
                  ? "text " + std::to_string(next())
                  : std::string(about.choices[1 + next() % (about.choices.size() - 1)]);
    else if constexpr (std::is_same_v<T, Amplitude>)
      value = Amplitude({{0.0, number({})}, {number(above(0.0)), 0.5}});
    else if constexpr (std::is_same_v<T, ScalarField>)
      value = number({});
    else
      value = Vec2(number(about.range), number(about.range));
  }

  void fill_shape(Shape& shape) { fill_kind<0>(shape, next() % std::variant_size_v<Shape>); }

  template <std::size_t kind>
  void fill_kind(Shape& shape, std::size_t wanted) {
    if constexpr (kind < std::variant_size_v<Shape>) {
      if (kind == wanted)
        fill(shape.emplace<kind>(), {});
      else
        fill_kind<kind + 1>(shape, wanted);
    }
  }

  int count_;
};

struct AnyValue;

// An optional is made from a value rather than converted to, where it can be.
template <class T>
inline constexpr bool holds_any = false;
template <class T>
inline constexpr bool holds_any<std::optional<T>> = std::is_constructible_v<T, AnyValue>;

struct AnyValue {
  template <class T>
  requires(!holds_any<T>) operator T() const;
};

// A vector claims to be made of anything, so an optional one needs a value of its own.
struct NoVector {
  operator std::optional<Vec2>() const;
};

// How many members an aggregate has: as many values as it can be made of.
template <class Noun, class... Values>
constexpr std::size_t count_members() {
  if constexpr (requires { Noun{Values{}..., NoVector{}}; })
    return count_members<Noun, Values..., NoVector>();
  else if constexpr (requires { Noun{Values{}..., AnyValue{}}; })
    return count_members<Noun, Values..., AnyValue>();
  else
    return sizeof...(Values);
}

// How many of them its description names; of one that says the kind of another, that too.
template <Described Noun>
std::size_t count_described() {
  const Noun noun{};
  std::set<const void*> places;
  for_each_member<Noun>([&](const auto& member) {
    places.insert(&(noun.*member.pointer));
    if constexpr (requires { member.kind; }) places.insert(&(noun.*member.kind));
  });
  return places.size();
}

}  // namespace hackle::test
