// SPDX-License-Identifier: MIT
// The arguments of one call, checked against the schema of its function.
#pragma once

#include <any>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/error.hpp"
#include "console/lua/lua_function.hpp"
#include "console/schema/schema.hpp"
#include "console/schema/value_reader.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// Collects every problem of a call; the function adds its own to `problems` and then calls
// problems.throw_if_any(). Until then, a missing or wrong value reads as its fallback.
class Arguments {
 public:
  // Reads the table at `index`. Also accepts a text there for the positional option, and nothing if
  // no option is required.
  static Arguments from_table(lua_State* L, int index, const FunctionDoc& doc);
  // Reads the values from `index` on, in the order of the options.
  static Arguments from_values(lua_State* L, int index, const FunctionDoc& doc);

  // Returns whether the function has this option.
  bool takes(std::string_view name) const { return find_option(*doc_, name) != nullptr; }
  bool has(std::string_view name) const { return at(name).value.has_value(); }
  // Returns whether none of these was missing or wrong.
  bool good(std::initializer_list<std::string_view> names) const;

  double number(std::string_view name, double fallback = 0.0) const;
  std::int64_t integer(std::string_view name, std::int64_t fallback = 0) const;
  std::string text(std::string_view name, std::string_view fallback = {}) const;
  std::vector<std::string> texts(std::string_view name) const;
  bool flag(std::string_view name, bool fallback = false) const;
  Vec2 point(std::string_view name) const;
  Vec2 pair(std::string_view name, const Vec2& fallback = {0, 0}) const;
  Eigen::Vector3d window(std::string_view name) const;  // x, y and half the width
  std::vector<Vec2> points(std::string_view name) const;
  std::vector<double> numbers(std::string_view name) const;
  // Requires has(name).
  LuaFunction function(std::string_view name) const;
  // Returns the text of a choice.
  std::string text_of_choice(std::string_view name, std::string_view fallback) const;
  // Returns a value of any type, also of a type that an option's own reader makes.
  template <class T>
  T get(std::string_view name, const T& fallback) const {
    if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>)
      return static_cast<T>(integer(name, static_cast<std::int64_t>(fallback)));
    else
      return value_or(name, fallback);
  }
  // Returns the enumerator whose index is that of the text among the choices.
  template <class Enum>
  Enum choice(std::string_view name, Enum fallback = {}) const {
    return static_cast<Enum>(value_or(name, Choice{static_cast<std::size_t>(fallback)}).index);
  }

  Problems problems;

 private:
  struct Slot {
    std::any value;  // from read_value()
    bool bad = false;
  };

  explicit Arguments(const FunctionDoc& doc) : doc_(&doc), slots_(doc.options.size()) {}

  const Slot& at(std::string_view name) const;
  template <class T>
  T value_or(std::string_view name, T fallback) const {
    const std::any& value = at(name).value;
    return value.has_value() ? std::any_cast<const T&>(value) : fallback;
  }

  void read_table(lua_State* L, int index);
  void read_positional(lua_State* L, int index, const Option& option);
  void read_rest(lua_State* L, int index, const Option& option);
  void report_others(lua_State* L, int index, lua_Integer known);
  void report_more(lua_State* L, int index);  // a value there or beyond
  void take(lua_State* L, int index, const Option& option);
  void require_all();
  void unknown_name(std::string_view name);

  const FunctionDoc* doc_;
  std::vector<Slot> slots_;  // one per option
};

}  // namespace hackle
