// SPDX-License-Identifier: MIT
// The options of a function that makes a noun, derived from the noun's description.
#pragma once

#include <array>
#include <type_traits>

#include "base/described.hpp"
#include "console/language/scripted_material.hpp"
#include "console/schema/arguments.hpp"
#include "scene/amplitude.hpp"
#include "scene/field_of_place.hpp"

namespace hackle {

// Returns how a script gives a member; nothing for a member that the function reads itself.
template <class T>
constexpr std::optional<OptionType> option_type() {
  if constexpr (std::is_same_v<T, bool>) return OptionType::flag;
  if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>>)
    return OptionType::number;
  if constexpr (std::is_integral_v<T>) return OptionType::integer;
  if constexpr (std::is_enum_v<T>) return OptionType::choice;
  if constexpr (std::is_same_v<T, std::string>) return OptionType::text;
  if constexpr (std::is_same_v<T, Vec2>) return OptionType::point;
  if constexpr (std::is_same_v<T, std::vector<Vec2>>) return OptionType::points;
  if constexpr (std::is_same_v<T, Material>) return OptionType::material;
  if constexpr (std::is_same_v<T, VectorField>) return OptionType::vector_field;
  if constexpr (std::is_same_v<T, ScalarField>) return OptionType::scalar_field;
  if constexpr (std::is_same_v<T, Amplitude>) return OptionType::amplitude;
  return std::nullopt;
}

template <class T>
constexpr Option option_of(std::string_view name, const About& about) {
  Option option{.name = name,
                .type = *option_type<T>(),
                .unit = about.unit,
                .range = about.range,
                .required = about.required,
                .fallback = about.fallback,
                .alternative = about.alternative,
                .sentence = about.sentence};
  if constexpr (std::is_enum_v<T>) option.choices = enum_names<T>;
  if constexpr (std::is_same_v<T, Material>) option.read = read_material;
  return option;
}

// Visits the name, the description and the type, as a value, of every member that is an option.
template <Described Noun, class Visit>
constexpr void for_each_option(const Visit& visit) {
  for_each_member<Noun>([&](const auto& member) {
    using T = typename std::remove_cvref_t<decltype(member)>::Value;
    if constexpr (!option_type<T>().has_value())
      return;
    else if constexpr (requires { member.kind; })
      for (std::size_t k = 0; k < member.names.size(); ++k)
        visit(member.names[k], member.abouts[k], std::type_identity<T>());
    else
      visit(member.name, member.about, std::type_identity<T>());
  });
}

template <Described Noun>
constexpr std::size_t count_options() {
  std::size_t count = 0;
  for_each_option<Noun>([&](auto, const About&, auto) { ++count; });
  return count;
}

template <Described Noun>
constexpr auto options_of = [] {
  std::array<Option, count_options<Noun>()> options;
  std::size_t next = 0;
  for_each_option<Noun>(
      [&]<class T>(std::string_view name, const About& about, std::type_identity<T>) {
        options[next++] = option_of<T>(name, about);
      });
  return options;
}();

// Sets the given members.
template <Described Noun>
void read_options(const Arguments& arguments, Noun& noun) {
  const auto given = [&](std::string_view name) {
    return arguments.takes(name) && arguments.has(name);
  };
  for_each_member<Noun>([&](const auto& member) {
    using T = typename std::remove_cvref_t<decltype(member)>::Value;
    if constexpr (!option_type<T>().has_value()) {
      return;
    } else if constexpr (requires { member.kind; }) {
      for (std::size_t k = 0; k < member.names.size(); ++k) {
        if (!given(member.names[k])) continue;
        noun.*member.kind = static_cast<std::remove_cvref_t<decltype(noun.*member.kind)>>(k);
        noun.*member.pointer = arguments.get<T>(member.names[k], noun.*member.pointer);
      }
    } else if (given(member.name)) {
      noun.*member.pointer = arguments.get<T>(member.name, noun.*member.pointer);
    }
  });
}

template <Described Noun>
Noun noun_of(const Arguments& arguments) {
  Noun noun;
  read_options(arguments, noun);
  return noun;
}

}  // namespace hackle
