// SPDX-License-Identifier: MIT
// Nouns that are described (base/described.hpp) as JSON, member by member.
#pragma once

#include <cstdint>
#include <iterator>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/described.hpp"
#include "scene/amplitude.hpp"
#include "scene/field_of_place.hpp"
#include "scene/shape.hpp"
#include "store/json_key.hpp"

namespace hackle {

// Written as a text in JSON, where null stands for an empty optional of it.
template <class T>
inline constexpr bool is_text = std::is_same_v<T, std::string> || std::is_enum_v<T>;

// json_of(noun) is an object with a key for each member, see key_of().
struct NounWriter {
  using Json = nlohmann::ordered_json;

  static Json json_of(const Vec2& vector) { return Json::array({vector.x(), vector.y()}); }

  // A function can only be written as its text; the function itself is in the script.
  static Json function_of(const std::string& text) { return {{"function", text}}; }

  static Json json_of(const Amplitude& amplitude) {
    if (amplitude.is_function()) return function_of(amplitude.describe());
    if (amplitude.is_constant()) return "constant";
    Json list = Json::array();
    for (const Vec2& point : amplitude.points()) list.push_back(json_of(point));
    return list;
  }

  template <class T>
  static Json json_of(const FieldOfPlace<T>& field) {
    if (!field.is_constant())
      return function_of(field.varies_in_time() ? "of place and time" : "of place");
    if constexpr (std::is_same_v<T, double>)
      return field.constant();
    else
      return json_of(field.constant());
  }

  static Json json_of(const Shape& shape) {
    Json json = {{"kind", kind_of(shape)}};
    std::visit([&](const auto& kind) { json.update(json_of(kind)); }, shape);
    return json;
  }

  // Writes run lengths, cells outside first, then inside, and so on: "12 3 40". It is a text
  // because a list would take a line per number.
  static std::string json_of(const std::vector<std::uint8_t>& cells) {
    std::string text;
    std::uint8_t value = 0;
    std::int64_t length = 0;
    const auto end_run = [&] { fmt::format_to(std::back_inserter(text), "{} ", length); };
    for (const std::uint8_t cell : cells) {
      if (cell != value) {
        end_run();
        value = cell;
        length = 0;
      }
      ++length;
    }
    end_run();
    text.pop_back();
    return text;
  }

  template <class T>
  static Json json_of(const std::vector<T>& things) {
    Json list = Json::array();
    for (const T& thing : things) list.push_back(value_of(thing, {}));
    return list;
  }

  template <class T>
  static Json value_of(const T& value, const About& about) {
    if constexpr (is_optional<T>) {
      if (value) return value_of(*value, about);
      return is_text<std::remove_cvref_t<decltype(*value)>> ? Json() : Json(about.nothing);
    } else if constexpr (std::is_enum_v<T>) {
      return name_of(value);
    } else if constexpr (requires { json_of(value); }) {
      return json_of(value);
    } else {
      return value;
    }
  }

  template <Described Noun>
  static Json json_of(const Noun& noun) {
    Json json = Json::object();
    for_each_member<Noun>([&](const auto& member) {
      const auto& value = noun.*member.pointer;
      if constexpr (requires { member.kind; }) {
        const auto kind = static_cast<std::size_t>(noun.*member.kind);
        json[key_of(member.names[kind], member.abouts[kind].unit)] =
            value_of(value, member.abouts[kind]);
      } else if (member.name.empty()) {
        json.update(value_of(value, member.about));
      } else {
        json[key_of(member.name, member.about.unit)] = value_of(value, member.about);
      }
    });
    return json;
  }
};

}  // namespace hackle
