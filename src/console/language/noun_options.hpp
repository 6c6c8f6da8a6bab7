// SPDX-License-Identifier: MIT
// The options of a function that makes a noun, derived from the noun's description.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/described.hpp"
#include "console/language/scripted_material.hpp"
#include "console/schema/arguments.hpp"
#include "scene/amplitude.hpp"
#include "scene/field_of_place.hpp"

namespace hackle {

// How a type is given that only one noun knows: to be specialised beside that noun.
struct OwnWay {
  OptionType type;
  ValueReader read = nullptr;  // see Option
};
template <class T>
inline constexpr std::optional<OwnWay> own_way = std::nullopt;
template <>
inline constexpr std::optional<OwnWay> own_way<Material> =
    OwnWay{OptionType::material, read_material};

// Returns how a script gives a member; nothing for a member that the function reads itself.
template <class T>
constexpr std::optional<OptionType> option_type() {
  if constexpr (own_way<T>.has_value()) return own_way<T>->type;
  if constexpr (std::is_same_v<T, std::optional<std::string>>) return OptionType::caption;
  if constexpr (is_optional<T>) return option_type<std::remove_cvref_t<decltype(*T())>>();
  if constexpr (std::is_same_v<T, bool>) return OptionType::flag;
  if constexpr (std::is_same_v<T, double>) return OptionType::number;
  if constexpr (std::is_integral_v<T>) return OptionType::integer;
  if constexpr (std::is_enum_v<T>) return OptionType::choice;
  if constexpr (std::is_same_v<T, std::string>) return OptionType::text;
  if constexpr (std::is_same_v<T, std::vector<std::string>>) return OptionType::texts;
  if constexpr (std::is_same_v<T, std::vector<double>>) return OptionType::numbers;
  if constexpr (std::is_same_v<T, Vec2>) return OptionType::point;
  if constexpr (std::is_same_v<T, std::vector<Vec2>>) return OptionType::points;
  if constexpr (std::is_same_v<T, VectorField>) return OptionType::vector_field;
  if constexpr (std::is_same_v<T, ScalarField>) return OptionType::scalar_field;
  if constexpr (std::is_same_v<T, Amplitude>) return OptionType::amplitude;
  return std::nullopt;
}

// Of an enumeration, or of an optional that holds one; else none.
template <class T>
constexpr std::span<const std::string_view> choices_of(const About& about) {
  if constexpr (is_optional<T>) return choices_of<std::remove_cvref_t<decltype(*T())>>(about);
  if constexpr (std::is_enum_v<T>) {
    if (about.or_none) return enum_names_or_none<T>;
    return enum_names<T>;
  }
  return about.choices;
}

template <class T>
constexpr Option option_of(std::string_view name, const About& about) {
  Option option{.name = name,
                .type = *option_type<T>(),
                .unit = about.unit,
                .range = about.range,
                .required = about.required,
                .fallback = about.fallback,
                .choices = choices_of<T>(about),
                .alternative = about.alternative,
                .sentence = about.sentence};
  if (!option.choices.empty()) option.type = OptionType::choice;
  const bool angles = option.type == OptionType::point && about.unit == "rad";
  if (angles) option.type = OptionType::pair;
  if constexpr (own_way<T>.has_value()) option.read = own_way<T>->read;
  return option;
}

// What was given, of an option that has() it. To be overloaded for a type that get() does not know.
template <class T>
void read_given(const Arguments& arguments, std::string_view name, const About& about, T& value) {
  if constexpr (is_optional<T>) {
    if (about.or_none && arguments.text_of_choice(name, "none") == "none")
      value.reset();
    else
      read_given(arguments, name, about, value.emplace());
  } else if constexpr (std::is_enum_v<T>) {
    value = value_named<T>(arguments.text_of_choice(name, "")).value();
  } else if constexpr (std::is_same_v<T, std::string>) {
    value = about.choices.empty() ? arguments.text(name) : arguments.text_of_choice(name, "");
  } else {
    value = arguments.get<T>(name, value);
  }
}

// Visits the name, the description and the type, as a value, of every member that is an option,
// those of parts without a name included.
template <Described Noun, class Visit>
constexpr void for_each_option(const Visit& visit) {
  for_each_member<Noun>([&](const auto& member) {
    using T = typename std::remove_cvref_t<decltype(member)>::Value;
    if constexpr (requires { member.kind; }) {
      for (std::size_t k = 0; k < member.names.size(); ++k)
        visit(member.names[k], member.abouts[k], std::type_identity<T>());
    } else if constexpr (option_type<T>().has_value()) {
      visit(member.name, member.about, std::type_identity<T>());
    } else if constexpr (Described<T>) {
      if (member.name.empty()) for_each_option<T>(visit);
    }
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
  const auto read = [&](std::string_view name, const About& about, auto& value) {
    const bool given = arguments.takes(name) && arguments.has(name);
    if (given) read_given(arguments, name, about, value);
    return given;
  };
  for_each_member<Noun>([&](const auto& member) {
    auto& value = noun.*member.pointer;
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (requires { member.kind; }) {
      for (std::size_t k = 0; k < member.names.size(); ++k)
        if (read(member.names[k], member.abouts[k], value))
          noun.*member.kind = static_cast<std::remove_cvref_t<decltype(noun.*member.kind)>>(k);
    } else if constexpr (option_type<T>().has_value()) {
      read(member.name, member.about, value);
    } else if constexpr (Described<T>) {
      if (member.name.empty()) read_options(arguments, value);
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
