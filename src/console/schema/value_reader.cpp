// SPDX-License-Identifier: MIT
#include "console/schema/value_reader.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/renamed.hpp"
#include "base/units.hpp"
#include "console/lua/description.hpp"
#include "console/lua/lua_function.hpp"
#include "console/schema/given_function.hpp"
#include "console/schema/point_file.hpp"
#include "console/session.hpp"
#include "scene/amplitude.hpp"
#include "scene/field_of_place.hpp"
#include "scene/vec2.hpp"

namespace hackle {
namespace {

// Reads {{a, b}, {c, d}, ...}; returns nothing for any other value.
std::optional<std::vector<Vec2>> points_at(lua_State* L, int index) {
  std::vector<Vec2> points;
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, index));
  for (lua_Integer k = 1; k <= count; ++k) {
    bool pair = lua_rawgeti(L, index, k) == LUA_TTABLE && lua_rawlen(L, -1) == 2;
    Vec2 point{0, 0};
    for (lua_Integer part = 1; pair && part <= 2; ++part) {
      pair = lua_rawgeti(L, -1, part) == LUA_TNUMBER;
      point[part - 1] = lua_tonumber(L, -1);
      lua_pop(L, 1);
    }
    lua_pop(L, 1);
    if (!pair) return std::nullopt;
    points.push_back(point);
  }
  return points;
}

// Reads the numbers of the table {a, b, ...}; returns nothing for any other value.
template <class Vector>
std::optional<Vector> numbers_at(lua_State* L, int index) {
  Vector numbers = Vector::Zero();
  int found = 0, others = 0;
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
    const lua_Integer place = lua_isinteger(L, -2) ? lua_tointeger(L, -2) : 0;
    if (place >= 1 && place <= numbers.size() && lua_type(L, -1) == LUA_TNUMBER) {
      numbers[place - 1] = lua_tonumber(L, -1);
      ++found;
    } else {
      ++others;
    }
  }
  return found == numbers.size() && others == 0 ? std::optional(numbers) : std::nullopt;
}

std::any read_number(const GivenValue& given) {
  const auto& [L, index, doc, option, problems] = given;
  if (lua_type(L, index) != LUA_TNUMBER) return given.wrong_type();
  const double value = lua_tonumber(L, index);
  if (auto found = objection(doc.name, option.name, value, option.unit, option.range))
    return given.wrong(std::move(*found));
  return value;
}

std::any read_integer(const GivenValue& given) {
  const auto& [L, index, doc, option, problems] = given;
  if (lua_type(L, index) != LUA_TNUMBER) return given.wrong_type();
  int whole = 0;
  const lua_Integer value = lua_tointegerx(L, index, &whole);
  if (whole == 0) return given.wrong_type();
  if (!option.range.holds(static_cast<double>(value)))
    return given.wrong(fmt::format("{} is {}{}{}, it must be {}", given.name(), value,
                                   option.unit.empty() ? "" : " ", option.unit,
                                   range_text(option)));
  return static_cast<std::int64_t>(value);
}

std::any read_text(const GivenValue& given) {
  if (lua_type(given.L, given.index) != LUA_TSTRING) return given.wrong_type();
  const std::string_view text = text_at(given.L, given.index);
  if (text.empty()) return given.wrong(fmt::format("{} is an empty text", given.name()));
  if (text.find('\0') != std::string_view::npos)
    return given.wrong(fmt::format("{} holds a zero byte", given.name()));
  return std::string(text);
}

std::any read_caption(const GivenValue& given) {
  const bool none =
      lua_type(given.L, given.index) == LUA_TSTRING && text_at(given.L, given.index).empty();
  return none ? std::any(std::string()) : read_text(given);
}

std::any read_texts(const GivenValue& given) {
  const auto& [L, index, doc, option, problems] = given;
  if (!given.is_list()) return {};
  std::vector<std::string> texts;
  for (lua_Unsigned k = 1; k <= lua_rawlen(L, index); ++k) {
    const bool is_text = lua_rawgeti(L, index, static_cast<lua_Integer>(k)) == LUA_TSTRING;
    if (is_text) texts.emplace_back(text_at(L, -1));
    lua_pop(L, 1);
    if (!is_text || texts.back().empty() || texts.back().find('\0') != std::string::npos)
      return given.wrong(
          fmt::format("{}: entry {} of {} is no text, or an empty one", doc.name, k, option.name));
  }
  return texts;
}

std::any read_flag(const GivenValue& given) {
  if (lua_type(given.L, given.index) != LUA_TBOOLEAN) return given.wrong_type();
  return lua_toboolean(given.L, given.index) != 0;
}

std::any read_point(const GivenValue& given) {
  const auto& [L, index, doc, option, problems] = given;
  if (lua_type(L, index) != LUA_TTABLE) return given.wrong_type();
  const auto point = numbers_at<Vec2>(L, index);
  if (!point)
    return given.wrong(
        fmt::format("{} is not a pair of numbers, expected {}", given.name(), expectation(option)));
  if (!point->allFinite())
    return given.wrong(fmt::format("{} is {{{}, {}}}, expected finite numbers", given.name(),
                                   number_text(point->x()), number_text(point->y())));
  return *point;
}

std::any read_pair(const GivenValue& given) {
  const Option& option = given.option;
  std::any value = read_point(given);
  if (!value.has_value()) return value;
  const auto& pair = std::any_cast<const Vec2&>(value);
  if (option.range.holds(pair.x()) && option.range.holds(pair.y())) return value;
  return given.wrong(fmt::format("{} is {{{}, {}}}, both must be {}", given.name(),
                                 quantity(pair.x(), option.unit), quantity(pair.y(), option.unit),
                                 range_text(option)));
}

std::any read_window(const GivenValue& given) {
  const auto& [L, index, doc, option, problems] = given;
  if (lua_type(L, index) != LUA_TTABLE) return given.wrong_type();
  const auto window = numbers_at<Eigen::Vector3d>(L, index);
  if (!window || !window->allFinite())
    return given.wrong(fmt::format("{} is not three finite numbers, expected {}", given.name(),
                                   expectation(option)));
  if (!option.range.holds(window->z()))
    return given.wrong(fmt::format("{}: half the width of {} is {}, it must be {}", doc.name,
                                   option.name, quantity(window->z(), option.unit),
                                   range_text(option)));
  return *window;
}

// Reads them from a file: a script may name one in place of a list.
std::any read_points_of_file(const GivenValue& given) {
  const std::any name = read_text(given);
  if (!name.has_value()) return {};
  const std::filesystem::path path =
      session_of(given.L).input_path(given.name(), std::any_cast<const std::string&>(name));
  try {
    const Range& range = given.option.range;
    const double max = std::min(range.max, static_cast<double>(max_point_file));
    std::vector<Vec2> points = read_point_file(path, static_cast<std::size_t>(max));
    if (range.holds(static_cast<double>(points.size()))) return points;
    return given.wrong(fmt::format("{}: '{}' has {} points, there must be {}", given.name(),
                                   path.string(), points.size(), range_text(given.option)));
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::files) throw;
    const Problem& problem = error.problems().front();
    return given.wrong(fmt::format("{}: {}", given.name(), problem.what), problem.remedy);
  }
}

}  // namespace

std::any read_points(const GivenValue& given) {
  const auto& [L, index, doc, option, problems] = given;
  if (lua_type(L, index) == LUA_TSTRING) return read_points_of_file(given);
  if (lua_type(L, index) != LUA_TTABLE) return given.wrong_type();
  const lua_Unsigned count = lua_rawlen(L, index);
  if (!option.range.holds(static_cast<double>(count)))
    return given.wrong(
        fmt::format("{} has {} points, there must be {}", given.name(), count, range_text(option)));
  if (entries(L, index) != count)
    return given.wrong(fmt::format("{} holds something that is no point, expected {}", given.name(),
                                   expectation(option)));
  std::vector<Vec2> points;
  for (lua_Unsigned k = 1; k <= count; ++k) {
    const bool is_table = lua_rawgeti(L, index, static_cast<lua_Integer>(k)) == LUA_TTABLE;
    const std::optional<Vec2> point =
        is_table ? numbers_at<Vec2>(L, lua_gettop(L)) : std::optional<Vec2>();
    lua_pop(L, 1);
    if (!point || !point->allFinite())
      return given.wrong(fmt::format("{}: point {} of {} is not {{x, y}}, two finite numbers",
                                     doc.name, k, option.name));
    points.push_back(*point);
  }
  return points;
}

namespace {

std::any read_numbers(const GivenValue& given) {
  const auto& [L, index, doc, option, problems] = given;
  if (!given.is_list()) return {};
  std::vector<double> numbers;
  for (lua_Unsigned k = 1; k <= lua_rawlen(L, index); ++k) {
    const bool typed = lua_rawgeti(L, index, static_cast<lua_Integer>(k)) == LUA_TNUMBER;
    numbers.push_back(lua_tonumber(L, -1));
    lua_pop(L, 1);
    if (!typed || !std::isfinite(numbers.back()))
      return given.wrong(
          fmt::format("{}: entry {} of {} is no finite number", doc.name, k, option.name));
  }
  return numbers;
}

std::any read_choice(const GivenValue& given) {
  const Option& option = given.option;
  if (lua_type(given.L, given.index) != LUA_TSTRING) return given.wrong_type();
  const std::string_view text = text_at(given.L, given.index);
  const auto found = std::ranges::find(option.choices, text);
  if (found == option.choices.end())
    return given.wrong(fmt::format("{} is {}{}, expected {}", given.name(), in_quotes(text),
                                   present_name(option.name, text, option.choices),
                                   expectation(option)));
  return Choice{static_cast<std::size_t>(found - option.choices.begin())};
}

std::any read_vector_field(const GivenValue& given) {
  if (lua_type(given.L, given.index) != LUA_TFUNCTION) {
    const std::any point = read_point(given);
    return point.has_value() ? std::any(VectorField(std::any_cast<const Vec2&>(point))) : point;
  }
  return field_of<Vec2>(LuaFunction(given.L, given.index, given.name()));
}

std::any read_scalar_field(const GivenValue& given) {
  if (lua_type(given.L, given.index) != LUA_TFUNCTION) {
    const std::any number = read_number(given);
    return number.has_value() ? std::any(ScalarField(std::any_cast<double>(number))) : number;
  }
  return field_of<double>(LuaFunction(given.L, given.index, given.name()));
}

std::any read_function(const GivenValue& given) {
  if (lua_type(given.L, given.index) != LUA_TFUNCTION) return given.wrong_type();
  return LuaFunction(given.L, given.index, given.name());
}

std::any read_amplitude(const GivenValue& given) {
  const auto& [L, index, doc, option, problems] = given;
  if (lua_type(L, index) == LUA_TFUNCTION) return amplitude_of(LuaFunction(L, index, given.name()));
  if (lua_type(L, index) != LUA_TTABLE) return given.wrong_type();
  const auto points = points_at(L, index);
  if (!points || points->empty())
    return given.wrong(
        fmt::format("{} is not a list of pairs, expected {}", given.name(), expectation(option)));
  Amplitude amplitude(*points);
  Problems found;
  check(amplitude, given.name(), found);
  for (const Problem& problem : found.list()) problems.add(problem.what, problem.remedy);
  return found.empty() ? std::any(std::move(amplitude)) : std::any();
}

}  // namespace

std::any read_value(const GivenValue& given) {
  if (given.option.read != nullptr) return given.option.read(given);
  switch (given.option.type) {
    case OptionType::number:
      return read_number(given);
    case OptionType::integer:
      return read_integer(given);
    case OptionType::text:
      return read_text(given);
    case OptionType::caption:
      return read_caption(given);
    case OptionType::texts:
      return read_texts(given);
    case OptionType::flag:
      return read_flag(given);
    case OptionType::point:
      return read_point(given);
    case OptionType::pair:
      return read_pair(given);
    case OptionType::window:
      return read_window(given);
    case OptionType::points:
      return read_points(given);
    case OptionType::numbers:
      return read_numbers(given);
    case OptionType::choice:
      return read_choice(given);
    case OptionType::vector_field:
      return read_vector_field(given);
    case OptionType::scalar_field:
      return read_scalar_field(given);
    case OptionType::amplitude:
      return read_amplitude(given);
    case OptionType::function:
      return read_function(given);
    case OptionType::markers:
    case OptionType::recordings:
    case OptionType::sources:
    case OptionType::columns:
    case OptionType::material:
    case OptionType::areas:
    case OptionType::reading:
      break;
  }
  assert(false);
  return {};
}

}  // namespace hackle
