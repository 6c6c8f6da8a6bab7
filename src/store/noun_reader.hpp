// SPDX-License-Identifier: MIT
// Nouns that are described (base/described.hpp) from JSON, member by member.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/text.hpp"
#include "store/noun_writer.hpp"

namespace hackle {

// Throws Error (files).
[[noreturn]] void refuse_inputs(const std::string& what);
[[noreturn]] void refuse_function();

// Reads the cells of bitmaps, and counts those of all of them.
class Cells {
 public:
  // From run lengths, outside first, which are a text or a list, `count` cells.
  std::vector<std::uint8_t> read(const NounWriter::Json& run_lengths, std::int64_t count);

 private:
  std::int64_t all_ = 0;
};

// Reads what NounWriter writes, member by member. A member that an older file lacks keeps its
// default, unless it is required.
class NounReader {
 public:
  using Json = NounWriter::Json;

  template <Described Noun>
  void read(const Json& json, Noun& noun) {
    if (!json.is_object()) refuse_inputs("something is of another type");
    for_each_member<Noun>([&](const auto& member) {
      auto& value = noun.*member.pointer;
      if constexpr (requires { member.kind; })
        read_kind(json, noun.*member.kind, value, member);
      else if constexpr (requires { read(json, value); })
        member.name.empty() ? read(json, value) : read_named(json, value, member);
      else
        read_named(json, value, member);
    });
  }
  void read(const Json& json, Bitmap& bitmap);

 private:
  template <class T, class MemberOfT>
  void read_named(const Json& json, T& value, const MemberOfT& member) {
    const std::string key = key_of(member.name, member.about.unit);
    if (json.contains(key))
      read_value(json.at(key), value, member.name);
    else if (member.about.required)
      refuse_inputs("something is missing or too large");
  }

  template <class Kind, class T, class MemberOfT>
  void read_kind(const Json& json, Kind& kind, T& value, const MemberOfT& member) {
    for (std::size_t k = 0; k < member.names.size(); ++k) {
      const std::string key = key_of(member.names[k], member.abouts[k].unit);
      if (!json.contains(key)) continue;
      kind = static_cast<Kind>(k);
      return read_value(json.at(key), value, member.names[k]);
    }
    refuse_inputs("something is missing or too large");
  }

  template <class T>
  void read_value(const Json& json, T& value, std::string_view name) {
    if constexpr (std::is_enum_v<T>) {
      const std::optional<T> found = value_named<T>(json.get_ref<const std::string&>());
      if (!found) refuse_inputs(fmt::format("{} is none of {}", name, comma_list(enum_names<T>)));
      value = *found;
    } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
      value = json.get<T>();
    } else {
      read(json, value);
    }
  }

  static bool is_function(const Json& json) { return json.is_object() || json == "function"; }

  void read(const Json& json, Vec2& vector) {
    vector = {json.at(0).get<double>(), json.at(1).get<double>()};
  }

  void read(const Json& json, VectorField& field) {
    Vec2 constant{0, 0};
    if (is_function(json))
      field = VectorField([](const Vec2&) -> Vec2 { refuse_function(); });
    else
      read(json, constant), field = constant;
  }

  void read(const Json& json, ScalarField& field) {
    if (is_function(json))
      field = ScalarField([](const Vec2&) -> double { refuse_function(); });
    else
      field = json.get<double>();
  }

  void read(const Json& json, Amplitude& amplitude) {
    if (json == "constant") return;
    if (json.is_array()) {
      std::vector<Vec2> points;
      read(json, points);
      amplitude = Amplitude(std::move(points));
    } else {
      const Json& text = json.is_object() ? json.at("function") : json;
      amplitude = Amplitude([](double) -> double { refuse_function(); }, text.get<std::string>());
    }
  }

  template <class T>
  void read(const Json& json, std::vector<T>& list) {
    for (const Json& entry : json) read_value(entry, list.emplace_back(), "");
  }

  // A word stands for an empty optional, null for that of a text.
  template <class T>
  void read(const Json& json, std::optional<T>& value) {
    const bool empty = is_text<T> ? json.is_null() : json.is_string();
    if (!empty) read_value(json, value.emplace(), "");
  }

  template <std::size_t... kinds>
  static std::string kinds_of_shapes(std::index_sequence<kinds...>) {
    return comma_list(std::array{description_of<std::variant_alternative_t<kinds, Shape>>.noun...});
  }

  void read(const Json& json, Shape& shape) { read_shape<0>(json, shape); }

  template <std::size_t kind>
  void read_shape(const Json& json, Shape& shape) {
    if constexpr (kind == std::variant_size_v<Shape>) {
      refuse_inputs("a shape is none of " + kinds_of_shapes(std::make_index_sequence<kind>()));
    } else {
      using Kind = std::variant_alternative_t<kind, Shape>;
      if (json.at("kind").get_ref<const std::string&>() != description_of<Kind>.noun)
        return read_shape<kind + 1>(json, shape);
      read(json, shape.emplace<Kind>());
    }
  }

  Cells cells_;
};

}  // namespace hackle
