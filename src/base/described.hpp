// SPDX-License-Identifier: MIT
// Nouns that a user fills, described once: the script name, unit, range, default and sentence of
// every member. Reading from Lua, help, completion, the reference, JSON out and in, and the range
// check all use the description beside the struct.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "base/error.hpp"

namespace hackle {

// A range of numbers; each end is included or excluded.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_inclusive = true;
  bool max_inclusive = true;

  constexpr bool holds(double value) const {
    return (min_inclusive ? value >= min : value > min) &&
           (max_inclusive ? value <= max : value < max);
  }
};

constexpr Range above(double min) {
  return {.min = min, .min_inclusive = false};
}
constexpr Range at_least(double min) {
  return {.min = min};
}
constexpr Range between(double min, double max) {
  return {.min = min, .max = max};
}
constexpr Range above_up_to(double min, double max) {
  return {.min = min, .max = max, .min_inclusive = false};
}
constexpr Range from_to_below(double min, double max) {
  return {.min = min, .max = max, .max_inclusive = false};
}
constexpr Range strictly_between(double min, double max) {
  return {.min = min, .max = max, .min_inclusive = false, .max_inclusive = false};
}

// Returns "between 320 and 7680 px", "above 0 m", "at least 0 and below 1", or "" for an unlimited
// range.
std::string range_text(const Range& range, std::string_view unit);

// Returns why `value` is not allowed as member `name` of the noun `who`: "crack: radius is -1 m, it
// must be above 0 m". Returns nothing if it is allowed.
std::optional<std::string> objection(std::string_view who, std::string_view name, double value,
                                     std::string_view unit, const Range& range);

// The facts about one member that readers, checks and help need.
struct About {
  std::string_view unit{};  // "Pa"; "" for none
  Range range{};            // of a list: range of its length
  bool required = false;
  bool alternative = false;                     // the user gives one of several alternatives
  std::string_view fallback{};                  // default as told to the user
  std::string_view nothing = "none";            // text in files for an empty optional
  bool or_none = false;                         // a script may say "none" for nothing
  std::span<const std::string_view> choices{};  // of a text: its values, apart from ""
  std::string_view sentence{};
  std::string_view remedy{};  // added to the error for a value out of range
};

// A named member. A nameless member stands for a nested noun, whose members are listed among those
// of the outer noun.
template <class Noun, class T>
struct Member {
  std::string_view name;
  T Noun::*pointer;
  About about;

  using Value = T;
};

template <class Noun, class T>
constexpr Member<Noun, T> member(std::string_view name, T Noun::*pointer, About about = {}) {
  return {name, pointer, about};
}

// A member whose name, unit and range depend on another member, its kind: one entry per enumerator,
// in order.
template <class Noun, class Kind, class T, std::size_t n>
struct KindMember {
  Kind Noun::*kind;
  T Noun::*pointer;
  std::array<std::string_view, n> names;
  std::array<About, n> abouts;

  using Value = T;
};

template <class Noun, class Kind, class T, std::size_t n>
constexpr KindMember<Noun, Kind, T, n> kind_member(Kind Noun::*kind, T Noun::*pointer,
                                                   std::array<std::string_view, n> names,
                                                   std::array<About, n> abouts) {
  return {kind, pointer, names, abouts};
}

// The description of a whole noun. `noun` is its name in messages and scripts, `counted` its name
// after a number: "2 body forces".
template <class... Members>
struct Description {
  std::string_view noun;
  std::string_view counted;
  std::tuple<Members...> members;
};

template <class... Members>
constexpr Description<Members...> describe_noun(std::string_view noun, std::string_view counted,
                                                Members... members) {
  return {noun, counted, std::tuple(members...)};
}

// Each noun specialises this beside its struct.
template <class Noun>
inline constexpr int description_of = 0;

template <class Noun>
concept Described = requires {
  description_of<Noun>.noun;
};

// What help says of the function that makes a noun, which is called as the noun. To be specialised
// beside a load that needs no function of its own: its options are then its members.
struct Introduction {
  std::string_view sentence{};
  std::string_view example{};         // on a plate: "p:name { ... }"
  std::string_view example_in_run{};  // on a simulation: "s:name { ... }"
  std::string_view see_also{};        // related functions: "body_force move"
};
template <class Noun>
inline constexpr Introduction introduction_of{};

// Visits every Member and KindMember in order.
template <Described Noun, class Visit>
constexpr void for_each_member(const Visit& visit) {
  std::apply([&](const auto&... members) { (visit(members), ...); }, description_of<Noun>.members);
}

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

template <class T>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;

// Whether two things are equal: nouns member by member, lists entry by entry.
template <class T>
bool same(const T& one, const T& other) {
  if constexpr (Described<T>) {
    bool equal = true;
    for_each_member<T>([&](const auto& member) {
      if constexpr (requires { member.kind; })
        equal = equal && one.*member.kind == other.*member.kind;
      equal = equal && same(one.*member.pointer, other.*member.pointer);
    });
    return equal;
  } else if constexpr (is_list<T>) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](const auto& a, const auto& b) { return same(a, b); });
  } else if constexpr (is_optional<T>) {
    return one.has_value() == other.has_value() && (!one || same(*one, *other));
  } else {
    return one == other;
  }
}

// The names of an enumeration's values in scripts and files, in order. Each enumeration specialises
// this beside its definition.
template <class Enum>
inline constexpr std::array<std::string_view, 0> enum_names{};

template <class Enum>
constexpr std::string_view name_of(Enum value) {
  return enum_names<Enum>[static_cast<std::size_t>(value)];
}

// The choices of a member that may be nothing.
template <std::size_t n>
constexpr std::array<std::string_view, n + 1> or_none(
    const std::array<std::string_view, n>& names) {
  std::array<std::string_view, n + 1> all{"none"};
  std::copy(names.begin(), names.end(), all.begin() + 1);
  return all;
}
template <class Enum>
inline constexpr auto enum_names_or_none = or_none(enum_names<Enum>);

// Returns nothing if no value has this name.
template <class Enum>
constexpr std::optional<Enum> value_named(std::string_view name) {
  const auto& names = enum_names<Enum>;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

}  // namespace hackle
