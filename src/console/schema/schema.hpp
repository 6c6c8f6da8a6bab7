// SPDX-License-Identifier: MIT
// The options of a function of the scene language, as data. The checker (arguments.hpp), help() and
// the reference pages all read it.
#pragma once

#include <algorithm>
#include <any>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "base/described.hpp"
#include "console/lua/lua_state.hpp"

namespace hackle {

enum class OptionType {
  number,        // finite
  integer,       // whole number
  text,          // not empty
  caption,       // may be empty
  texts,         // a list of text; range of its length
  flag,          // true or false
  point,         // {x, y}, two finite numbers; a place or a vector
  pair,          // {a, b}, two finite numbers, each in the range
  window,        // {x, y, half}, the middle of a window and half its width in the range
  points,        // a list of points, or the name of a file of such; range of its length
  markers,       // a list of {x, y, "label"}; range of its length
  numbers,       // a list of finite numbers; range of its length
  recordings,    // a list of values of recording{...}; range of its length
  sources,       // a list of files, recordings and tables of numbers; range of its length
  columns,       // a list of names, functions and gauges; range of its length
  choice,        // one of `choices`
  material,      // its name, or a value of material{...}
  areas,         // {centre = ..., radius = ...}, the options of a shape, or a list of such
  vector_field,  // {x, y}, or a function of x and y that returns two numbers
  scalar_field,  // a number, or a function of x and y that returns one
  amplitude,     // {{t, factor}, ...} in time, or a function of t
  function,      // of Lua
  reading,       // a number, a list of numbers or a function that returns one
};

struct GivenValue;
// Returns the value, or nothing after adding a problem (value_reader.hpp).
using ValueReader = std::any (*)(const GivenValue& given);

struct Option {
  std::string_view name;
  OptionType type = OptionType::number;
  ValueReader read = nullptr;  // beside its binding; what one noun knows needs one
  std::string_view unit{};     // "" for none
  Range range{};
  bool required = false;
  std::string_view unless{};    // an option that makes this one unnecessary
  bool positional = false;      // may be given as [1], without its name
  bool rest = false;            // may be given as [2], [3], ..., without its name
  std::string_view fallback{};  // default as told to the user
  std::span<const std::string_view> choices{};
  bool alternative = false;  // the user gives one of several alternatives; its function checks this
  std::string_view sentence{};
};

// How a function is called.
enum class Call {
  options,  // f { name = value, ... }
  values,   // f(value, ...): the options in order
  free,     // the function checks its arguments itself
};

// Returns the options of both.
template <class T, std::size_t A, std::size_t B>
constexpr std::array<T, A + B> joined(const std::array<T, A>& first,
                                      const std::array<T, B>& second) {
  std::array<T, A + B> all;
  std::ranges::copy(second, std::ranges::copy(first, all.begin()).out);
  return all;
}

// Returns all except the option of this name, which must exist.
template <std::size_t N>
constexpr std::array<Option, N - 1> without(std::string_view name,
                                            const std::array<Option, N>& options) {
  std::array<Option, N - 1> others;
  std::ranges::copy_if(options, others.begin(),
                       [&](const Option& option) { return option.name != name; });
  return others;
}

struct FunctionDoc {
  std::string_view name;
  std::string_view owner{};    // "p" for p:crack, "" for a global function
  std::string_view leading{};  // arguments before the options, "p"
  Call call = Call::options;
  std::string_view sentence{};
  std::span<const Option> options{};
  std::string_view example{};  // runs unchanged, with a plate p and a simulation s
};

// What becomes of a function when a script is run again up to where it stopped
// (console/replay/replay.hpp).
enum class Replayed {
  tells,     // what it returned is known; what it wrote is written
  declares,  // it is called again
  hands,     // it returned an object, whose methods are known in turn
  runs,      // a run is passed over
  advances,  // slow loading, likewise
  outside    // it has nothing to do with the state of a simulation
};

// A function of the scene language: its doc and its implementation.
struct Function {
  const FunctionDoc* doc = nullptr;
  lua_CFunction call = nullptr;
  Replayed replayed = Replayed::tells;  // of methods of a simulation
};

// A read-only value of an object.
struct Property {
  std::string_view name;
  std::string_view unit{};
  std::string_view sentence{};
  lua_CFunction push = nullptr;              // [-0, +1], with the object at index 1
  std::span<const std::string_view> keys{};  // of its value, if that is a table
};

// A type of the scene language.
struct TypeDoc {
  std::string_view name;  // "plate"
  std::string_view sentence{};
  std::span<const Function> methods{};
  std::span<const Property> fields{};
  lua_CFunction to_text = nullptr;
  lua_CFunction destroy = nullptr;
};

// Returns "plate" or "p:crack".
std::string call_name(const FunctionDoc& doc);

// Returns "p:crack { from, to, born }" or "s:run(duration)".
std::string signature(const FunctionDoc& doc);

// Returns the kind of value that an option expects: "a number in m", "one of left, right".
std::string expectation(const Option& option);

// Returns "above 0 m", "between 320 and 7680 px", or "" for an unlimited range.
std::string range_text(const Option& option);

// Returns the option of this name, or null.
const Option* find_option(const FunctionDoc& doc, std::string_view name);

// Returns the method or field of this name, or null.
const Function* find_method(const TypeDoc& type, std::string_view name);
const Property* find_field(const TypeDoc& type, std::string_view name);

}  // namespace hackle
