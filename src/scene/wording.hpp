// SPDX-License-Identifier: MIT
// Nouns that are described (base/described.hpp) in words, for a person: "edge top, stress (0 Pa, 12
// MPa)".
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "base/described.hpp"
#include "base/units.hpp"
#include "scene/amplitude.hpp"
#include "scene/field_of_place.hpp"
#include "scene/shape.hpp"

namespace hackle {

// Numbers have four digits and a prefix, or, where two that look alike must be told apart, as many
// digits as they need and their SI unit.
class Wording {
 public:
  enum class Digits { four, all };
  explicit Wording(Digits digits = Digits::four) : digits_(digits) {}

  // Returns a value in words. Of a noun: its members, apart from those of a fresh one.
  template <class T>
  std::string operator()(const T& value, const About& about = {}) const {
    if constexpr (is_optional<T>)
      return value ? (*this)(*value, about) : std::string(about.nothing);
    else if constexpr (std::is_enum_v<T>)
      return std::string(name_of(value));
    else if constexpr (std::is_same_v<T, Shape>)
      return std::visit(
          [&](const auto& kind) { return fmt::format("{} {}", kind_of(value), (*this)(kind)); },
          value);
    else if constexpr (Described<T>)
      return members_of(value);
    else
      return text_of(value, about);
  }

 private:
  static constexpr std::size_t max_entries = 8;  // of a list

  std::string text_of(bool value, const About&) const { return value ? "true" : "false"; }
  std::string text_of(int value, const About&) const { return std::to_string(value); }
  std::string text_of(std::int64_t value, const About&) const { return std::to_string(value); }
  std::string text_of(const std::string& value, const About&) const { return value; }
  std::string text_of(double value, const About& about) const {
    if (digits_ == Digits::four || about.unit.empty())
      return digits_ == Digits::four ? quantity(value, about.unit) : shortest(value);
    return fmt::format("{} {}", shortest(value), about.unit);
  }
  std::string text_of(const Vec2& value, const About& about) const {
    return fmt::format("({}, {})", text_of(value.x(), about), text_of(value.y(), about));
  }

  std::string text_of(const Amplitude& amplitude, const About&) const {
    if (digits_ == Digits::four || amplitude.is_constant() || amplitude.is_function())
      return amplitude.describe();
    return entries(amplitude.points(), {}, amplitude.points().size());
  }

  template <class T>
  std::string text_of(const FieldOfPlace<T>& field, const About& about) const {
    if (field.is_constant()) return text_of(field.constant(), about);
    return field.varies_in_time() ? "a function of place and time" : "a function of place";
  }

  std::string text_of(const std::vector<std::uint8_t>& cells, const About&) const {
    return fmt::format("{} cells", grouped(static_cast<long long>(cells.size())));
  }

  template <class T>
  std::string text_of(const std::vector<T>& list, const About& about) const {
    return entries(list, about, digits_ == Digits::all ? list.size() : max_entries);
  }

  template <class T>
  std::string entries(const std::vector<T>& list, const About& about, std::size_t max) const {
    std::string text;
    for (const T& entry : list) {
      if (max-- == 0) return fmt::format("{} ... ({} in all)", text, list.size());
      if (!text.empty()) text += ' ';
      text += (*this)(entry, about);
    }
    return text.empty() ? "none" : text;
  }

  static void add(std::string& text, std::string_view name, const std::string& words) {
    if (words.empty()) return;
    if (!text.empty()) text += ", ";
    text.append(name);
    if (!name.empty()) text += ' ';
    text += words;
  }

  template <Described Noun>
  std::string members_of(const Noun& noun) const {
    const Noun fresh{};
    std::string text;
    for_each_member<Noun>([&](const auto& member) {
      const auto& value = noun.*member.pointer;
      if constexpr (requires { member.kind; }) {
        const auto kind = static_cast<std::size_t>(noun.*member.kind);
        add(text, member.names[kind], (*this)(value, member.abouts[kind]));
      } else if (!same(value, fresh.*member.pointer)) {
        // A shape says itself what it is.
        constexpr bool is_shape = std::is_same_v<std::remove_cvref_t<decltype(value)>, Shape>;
        add(text, is_shape ? "" : member.name, (*this)(value, member.about));
      }
    });
    return text;
  }

  Digits digits_;
};

}  // namespace hackle
