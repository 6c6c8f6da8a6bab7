// SPDX-License-Identifier: MIT
#include "console/language/scripted_expectation.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "console/lua/description.hpp"

namespace hackle {
namespace {

using Numbers = std::vector<double>;

std::any read_list(const GivenValue& given) {
  lua_State* L = given.L;
  if (!given.is_list()) return {};
  Numbers numbers;
  for (lua_Unsigned k = 1; k <= lua_rawlen(L, given.index); ++k) {
    const bool number = lua_rawgeti(L, given.index, static_cast<lua_Integer>(k)) == LUA_TNUMBER;
    numbers.push_back(lua_tonumber(L, -1));
    lua_pop(L, 1);
    if (!number)
      return given.wrong(
          fmt::format("{}: entry {} of {} is no number", given.doc.name, k, given.option.name));
  }
  return Reading(std::move(numbers));
}

double call(const LuaFunction& function, std::span<const double> at, const std::string& where) {
  double result = 0.0;
  function.call(at, {&result, 1}, where);
  return result;
}

// Returns the number of each place; of one place, without coordinate, if there is no curve.
Numbers numbers_of(const Reading& reading, const Numbers& at) {
  const std::size_t count = at.empty() ? 1 : at.size();
  if (const auto* number = std::get_if<double>(&reading)) return Numbers(count, *number);
  if (const auto* list = std::get_if<Numbers>(&reading)) return *list;
  const auto* function = std::get_if<LuaFunction>(&reading);
  if (function == nullptr) return Numbers(count, std::nan(""));
  if (at.empty()) return {call(*function, {}, "at the end")};
  Numbers numbers;
  for (const double& x : at) numbers.push_back(call(*function, {&x, 1}, "at " + shortest(x)));
  return numbers;
}

// How many tolerances a point is off; infinite if it was not found.
double badness(const Expectation& e, double expected, double got) {
  const double off = std::abs(got - expected);
  const double tolerance = e.relative > 0.0 ? e.relative * std::abs(expected) : e.tolerance;
  if (!std::isfinite(off)) return std::numeric_limits<double>::infinity();
  return off <= tolerance && tolerance == 0.0 ? 0.0 : off / tolerance;
}

// Takes the point that is off by most tolerances.
void take_curve(Expectation& e, Numbers expected, Numbers got) {
  std::size_t worst = 0;
  for (std::size_t k = 1; k < got.size(); ++k)
    if (badness(e, expected[k], got[k]) > badness(e, expected[worst], got[worst])) worst = k;
  e.expected = expected[worst];
  if (std::isfinite(got[worst])) e.got = got[worst];
  e.curve.expected = std::move(expected);
  e.curve.got = std::move(got);
}

void take_numbers(Expectation& e, const Reading& value, const Reading& got) {
  const bool has_value = !std::holds_alternative<std::monostate>(value);
  const Numbers expected = numbers_of(value, e.curve.x), found = numbers_of(got, e.curve.x);
  if (!e.curve.x.empty()) {
    take_curve(e, expected, found);
  } else {
    if (has_value) e.expected = expected.front();
    if (std::isfinite(found.front())) e.got = found.front();
  }
  if (e.expected && e.relative > 0.0) e.tolerance = e.relative * std::abs(*e.expected);
}

}  // namespace

std::any read_reading(const GivenValue& given) {
  lua_State* L = given.L;
  switch (lua_type(L, given.index)) {
    case LUA_TNUMBER:
      return Reading(lua_tonumber(L, given.index));
    case LUA_TFUNCTION:
      return Reading(LuaFunction(L, given.index, given.name()));
    case LUA_TTABLE:
      return read_list(given);
    default:
      return given.wrong_type();
  }
}

Expectation ScriptedExpectation::settled() const {
  Expectation e = known;
  try {
    take_numbers(e, value, got);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted) throw;
    e.got.reset();
    e.curve = {};
    e.reason = error.problems().front().what;
  }
  return e;
}

}  // namespace hackle
