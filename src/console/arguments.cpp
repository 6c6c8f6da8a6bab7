// SPDX-License-Identifier: MIT
// Tables are read with raw access only: no metamethod of a script runs in the middle of a check.
#include "console/arguments.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/units.hpp"
#include "console/guard.hpp"
#include "console/lua_function.hpp"
#include "console/material_binding.hpp"
#include "console/recording_binding.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

constexpr std::size_t longest_quote = 40;

std::string in_quotes(std::string_view text) {
  if (text.size() <= longest_quote) return fmt::format("'{}'", text);
  return fmt::format("'{}...'", text.substr(0, longest_quote));
}

std::string_view text_at(lua_State* L, int index) {
  std::size_t size = 0;
  const char* text = lua_tolstring(L, index, &size);
  return {text, size};
}

std::string object_name(lua_State* L, int index) {
  std::string name = "userdata";
  if (luaL_getmetafield(L, index, "__name") != LUA_TNIL) {
    if (lua_type(L, -1) == LUA_TSTRING) name = lua_tostring(L, -1);
    lua_pop(L, 1);
  }
  if (name.starts_with(type_prefix)) name.erase(0, type_prefix.size());
  return "a " + name;
}

std::string number_text(double value) {
  return std::isnan(value) ? "nan" : shortest(value);
}

std::vector<std::string_view> names_of(const FunctionDoc& doc) {
  std::vector<std::string_view> names;
  for (const Option& option : doc.options) names.push_back(option.name);
  return names;
}

const Option* find_positional(const FunctionDoc& doc) {
  const auto found = std::ranges::find(doc.options, true, &Option::positional);
  return found == doc.options.end() ? nullptr : &*found;
}

std::string at_place(const Vec2& place) {
  return fmt::format("at x = {}, y = {}", quantity(place.x(), "m"), quantity(place.y(), "m"));
}

// {{a, b}, {c, d}, ...}, or nothing when it is anything else.
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

// The numbers of the table {a, b, ...}, or nothing when it is something else.
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

// Of a table, under keys of any kind.
std::size_t entries(lua_State* L, int index) {
  std::size_t count = 0;
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) ++count;
  return count;
}

// {x, y, "label"}, or nothing when it is anything else.
std::optional<Marker> marker_at(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TTABLE || entries(L, index) != 3) return std::nullopt;
  const bool typed = lua_rawgeti(L, index, 1) == LUA_TNUMBER &&
                     lua_rawgeti(L, index, 2) == LUA_TNUMBER &&
                     lua_rawgeti(L, index, 3) == LUA_TSTRING;
  std::optional<Marker> marker;
  if (typed) {
    const std::string_view label = text_at(L, -1);
    marker = Marker{{lua_tonumber(L, -3), lua_tonumber(L, -2)}, std::string(label)};
    if (!marker->place.allFinite() || label.find('\0') != std::string_view::npos) marker.reset();
  }
  lua_settop(L, index);
  return marker;
}

}  // namespace

std::string description(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TNONE:
    case LUA_TNIL:
      return "nothing";
    case LUA_TBOOLEAN:
      return lua_toboolean(L, index) ? "true" : "false";
    case LUA_TNUMBER:
      return lua_isinteger(L, index) ? std::to_string(lua_tointeger(L, index))
                                     : number_text(lua_tonumber(L, index));
    case LUA_TSTRING:
      return "the text " + in_quotes(text_at(L, index));
    case LUA_TUSERDATA:
      return object_name(L, index);
    default:
      return fmt::format("a {}", luaL_typename(L, index));
  }
}

Arguments Arguments::from_table(lua_State* L, int index, const FunctionDoc& doc) {
  Arguments arguments(doc);
  const Option* positional = find_positional(doc);
  if (lua_type(L, index) == LUA_TSTRING && positional != nullptr)
    arguments.read_value(L, index, *positional);
  else if (lua_type(L, index) == LUA_TTABLE)
    arguments.read_table(L, lua_absindex(L, index));
  else if (!lua_isnone(L, index) || std::ranges::any_of(doc.options, &Option::required))
    throw Error(
        ErrorKind::refused,
        fmt::format("{}: expected options in braces, got {}", doc.name, description(L, index)),
        fmt::format("as in {}", doc.example));
  arguments.report_more(L, index + 1);
  arguments.require_all();
  return arguments;
}

Arguments Arguments::from_values(lua_State* L, int index, const FunctionDoc& doc) {
  Arguments arguments(doc);
  int at = index;
  for (const Option& option : doc.options) {
    if (!lua_isnoneornil(L, at)) arguments.read_value(L, at, option);
    ++at;
  }
  arguments.report_more(L, at);
  arguments.require_all();
  return arguments;
}

void Arguments::report_more(lua_State* L, int index) {
  if (lua_gettop(L) < index) return;
  problems.add(fmt::format("{}: {} is one value too many", doc_->name, description(L, index)),
               fmt::format("it is called as {}", signature(*doc_)));
}

// In the order of the options, then what is none of them by name: Lua orders its tables anew in
// every process, and messages must not change with it.
void Arguments::read_table(lua_State* L, int index) {
  for (const Option& option : doc_->options) {
    lua_pushlstring(L, option.name.data(), option.name.size());
    if (lua_rawget(L, index) != LUA_TNIL) read_value(L, lua_gettop(L), option);
    lua_pop(L, 1);
  }
  const Option* positional = find_positional(*doc_);
  if (positional != nullptr) read_positional(L, index, *positional);
  report_others(L, index, positional != nullptr);
}

void Arguments::read_positional(lua_State* L, int index, const Option& option) {
  if (lua_rawgeti(L, index, 1) != LUA_TNIL) {
    if (has(option.name) || at(option.name).bad)
      problems.add(fmt::format("{}: {} is given twice", doc_->name, option.name));
    else
      read_value(L, lua_gettop(L), option);
  }
  lua_pop(L, 1);
}

void Arguments::report_others(lua_State* L, int index, bool first_is_known) {
  std::set<std::string> unknown, nameless;
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
    const bool named = lua_type(L, -2) == LUA_TSTRING;
    const bool first = lua_isinteger(L, -2) && lua_tointeger(L, -2) == 1;
    if (named && find_option(*doc_, text_at(L, -2)) == nullptr) unknown.emplace(text_at(L, -2));
    if (!named && !(first && first_is_known)) nameless.insert(description(L, -1));
  }
  for (const std::string& name : unknown) unknown_name(name);
  for (const std::string& value : nameless)
    problems.add(fmt::format("{}: {} stands in the braces without a name", doc_->name, value),
                 fmt::format("write name = value; names: {}", comma_list(names_of(*doc_))));
}

void Arguments::unknown_name(std::string_view name) {
  const auto names = names_of(*doc_);
  const auto near = nearest(name, names);
  problems.add(fmt::format("{}: unknown option {}", doc_->name, in_quotes(name)),
               (near ? fmt::format("did you mean '{}'? ", *near) : "") +
                   (names.empty() ? "it takes none" : "options: " + comma_list(names)));
}

void Arguments::require_all() {
  for (const Option& option : doc_->options)
    if (option.required && !has(option.name) && !at(option.name).bad)
      wrong(option, fmt::format("{}: {} is missing", doc_->name, option.name), expectation(option));
}

void Arguments::read_value(lua_State* L, int index, const Option& option) {
  switch (option.type) {
    case OptionType::number:
      return take_number(L, index, option);
    case OptionType::integer:
      return take_integer(L, index, option);
    case OptionType::text:
      return take_text(L, index, option);
    case OptionType::caption:
      return take_caption(L, index, option);
    case OptionType::texts:
      return take_texts(L, index, option);
    case OptionType::flag:
      return take_flag(L, index, option);
    case OptionType::point:
      return take_point(L, index, option);
    case OptionType::pair:
      return take_pair(L, index, option);
    case OptionType::window:
      return take_window(L, index, option);
    case OptionType::points:
      return take_points(L, index, option);
    case OptionType::markers:
      return take_markers(L, index, option);
    case OptionType::numbers:
      return take_numbers(L, index, option);
    case OptionType::recordings:
      return take_recordings(L, index, option);
    case OptionType::choice:
      return take_choice(L, index, option);
    case OptionType::material:
      return take_material(L, index, option);
    case OptionType::vector_field:
      return take_vector_field(L, index, option);
    case OptionType::scalar_field:
      return take_scalar_field(L, index, option);
    case OptionType::course:
      return take_course(L, index, option);
    case OptionType::function:
      return take_function(L, index, option);
  }
}

void Arguments::take_number(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) != LUA_TNUMBER) return wrong_type(L, index, option);
  const double value = lua_tonumber(L, index);
  if (auto found = objection(doc_->name, option.name, value, option.unit, option.range))
    return wrong(option, std::move(*found));
  keep(option, value);
}

void Arguments::take_integer(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) != LUA_TNUMBER) return wrong_type(L, index, option);
  int whole = 0;
  const lua_Integer value = lua_tointegerx(L, index, &whole);
  if (whole == 0) return wrong_type(L, index, option);
  if (!option.range.holds(static_cast<double>(value)))
    return wrong(option,
                 fmt::format("{}: {} is {}{}{}, it must be {}", doc_->name, option.name, value,
                             option.unit.empty() ? "" : " ", option.unit, range_text(option)));
  keep(option, static_cast<std::int64_t>(value));
}

void Arguments::take_text(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) != LUA_TSTRING) return wrong_type(L, index, option);
  const std::string_view text = text_at(L, index);
  if (text.empty())
    return wrong(option, fmt::format("{}: {} is an empty text", doc_->name, option.name));
  if (text.find('\0') != std::string_view::npos)
    return wrong(option, fmt::format("{}: {} holds a zero byte", doc_->name, option.name));
  keep(option, std::string(text));
}

void Arguments::take_caption(lua_State* L, int index, const Option& option) {
  const bool none = lua_type(L, index) == LUA_TSTRING && text_at(L, index).empty();
  return none ? keep(option, std::string()) : take_text(L, index, option);
}

void Arguments::take_texts(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) != LUA_TTABLE) return wrong_type(L, index, option);
  const lua_Unsigned count = lua_rawlen(L, index);
  if (!option.range.holds(static_cast<double>(count)) || entries(L, index) != count)
    return wrong(option,
                 fmt::format("{}: {} is not {}", doc_->name, option.name, expectation(option)));
  std::vector<std::string> texts;
  for (lua_Unsigned k = 1; k <= count; ++k) {
    const bool is_text = lua_rawgeti(L, index, static_cast<lua_Integer>(k)) == LUA_TSTRING;
    if (is_text) texts.emplace_back(text_at(L, -1));
    lua_pop(L, 1);
    if (!is_text || texts.back().empty() || texts.back().find('\0') != std::string::npos)
      return wrong(option, fmt::format("{}: entry {} of {} is no text, or an empty one", doc_->name,
                                       k, option.name));
  }
  keep(option, std::move(texts));
}

void Arguments::take_flag(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) != LUA_TBOOLEAN) return wrong_type(L, index, option);
  keep(option, lua_toboolean(L, index) != 0);
}

void Arguments::take_point(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) != LUA_TTABLE) return wrong_type(L, index, option);
  const auto point = numbers_at<Vec2>(L, index);
  if (!point)
    return wrong(option, fmt::format("{}: {} is not a pair of numbers, expected {}", doc_->name,
                                     option.name, expectation(option)));
  if (!point->allFinite())
    return wrong(option,
                 fmt::format("{}: {} is {{{}, {}}}, expected finite numbers", doc_->name,
                             option.name, number_text(point->x()), number_text(point->y())));
  keep(option, *point);
}

void Arguments::take_pair(lua_State* L, int index, const Option& option) {
  take_point(L, index, option);
  if (!has(option.name)) return;
  const Vec2 value = pair(option.name);
  if (option.range.holds(value.x()) && option.range.holds(value.y())) return;
  slots_[static_cast<std::size_t>(&option - doc_->options.data())].value.reset();
  wrong(option, fmt::format("{}: {} is {{{}, {}}}, both must be {}", doc_->name, option.name,
                            quantity(value.x(), option.unit), quantity(value.y(), option.unit),
                            range_text(option)));
}

void Arguments::take_window(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) != LUA_TTABLE) return wrong_type(L, index, option);
  const auto window = numbers_at<Eigen::Vector3d>(L, index);
  if (!window || !window->allFinite())
    return wrong(option, fmt::format("{} is not three finite numbers, expected {}",
                                     full_name(option), expectation(option)));
  if (!option.range.holds(window->z()))
    return wrong(option,
                 fmt::format("{}: half the width of {} is {}, it must be {}", doc_->name,
                             option.name, quantity(window->z(), option.unit), range_text(option)));
  keep(option, *window);
}

void Arguments::take_points(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) != LUA_TTABLE) return wrong_type(L, index, option);
  const lua_Unsigned count = lua_rawlen(L, index);
  if (!option.range.holds(static_cast<double>(count)))
    return wrong(option, fmt::format("{}: {} has {} points, there must be {}", doc_->name,
                                     option.name, count, range_text(option)));
  if (entries(L, index) != count)
    return wrong(option, fmt::format("{}: {} holds something that is no point, expected {}",
                                     doc_->name, option.name, expectation(option)));
  std::vector<Vec2> points;
  for (lua_Unsigned k = 1; k <= count; ++k) {
    const bool is_table = lua_rawgeti(L, index, static_cast<lua_Integer>(k)) == LUA_TTABLE;
    const std::optional<Vec2> point =
        is_table ? numbers_at<Vec2>(L, lua_gettop(L)) : std::optional<Vec2>();
    lua_pop(L, 1);
    if (!point || !point->allFinite())
      return wrong(option, fmt::format("{}: point {} of {} is not {{x, y}}, two finite numbers",
                                       doc_->name, k, option.name));
    points.push_back(*point);
  }
  keep(option, std::move(points));
}

void Arguments::take_markers(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) != LUA_TTABLE) return wrong_type(L, index, option);
  const lua_Unsigned count = lua_rawlen(L, index);
  if (!option.range.holds(static_cast<double>(count)) || entries(L, index) != count)
    return wrong(option, fmt::format("{} is not {}", full_name(option), expectation(option)));
  std::vector<Marker> markers;
  for (lua_Unsigned k = 1; k <= count; ++k) {
    lua_rawgeti(L, index, static_cast<lua_Integer>(k));
    const std::optional<Marker> marker = marker_at(L, lua_gettop(L));
    lua_pop(L, 1);
    if (!marker)
      return wrong(option,
                   fmt::format("{}: entry {} of {} is not {{x, y, \"label\"}}, two finite numbers "
                               "and a text",
                               doc_->name, k, option.name));
    markers.push_back(*marker);
  }
  keep(option, std::move(markers));
}

// Whether a list is there that is as long as the option says; says so if not.
bool Arguments::is_list(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) != LUA_TTABLE) {
    wrong_type(L, index, option);
    return false;
  }
  const lua_Unsigned count = lua_rawlen(L, index);
  if (option.range.holds(static_cast<double>(count)) && entries(L, index) == count) return true;
  wrong(option, fmt::format("{} is not {}", full_name(option), expectation(option)));
  return false;
}

void Arguments::take_numbers(lua_State* L, int index, const Option& option) {
  if (!is_list(L, index, option)) return;
  std::vector<double> numbers;
  for (lua_Unsigned k = 1; k <= lua_rawlen(L, index); ++k) {
    const bool typed = lua_rawgeti(L, index, static_cast<lua_Integer>(k)) == LUA_TNUMBER;
    numbers.push_back(lua_tonumber(L, -1));
    lua_pop(L, 1);
    if (!typed || !std::isfinite(numbers.back()))
      return wrong(option, fmt::format("{}: entry {} of {} is no finite number", doc_->name, k,
                                       option.name));
  }
  keep(option, std::move(numbers));
}

void Arguments::take_recordings(lua_State* L, int index, const Option& option) {
  if (!is_list(L, index, option)) return;
  std::vector<std::shared_ptr<Recording>> recordings;
  for (lua_Unsigned k = 1; k <= lua_rawlen(L, index); ++k) {
    lua_rawgeti(L, index, static_cast<lua_Integer>(k));
    const auto* scripted = object_at<ScriptedRecording>(L, -1);
    if (scripted != nullptr) recordings.push_back(scripted->recording);
    lua_pop(L, 1);
    if (scripted == nullptr)
      return wrong(option,
                   fmt::format("{}: entry {} of {} is no recording", doc_->name, k, option.name),
                   "recording \"run.h5\" opens one");
  }
  keep(option, std::move(recordings));
}

void Arguments::take_choice(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) != LUA_TSTRING) return wrong_type(L, index, option);
  const std::string_view text = text_at(L, index);
  const auto found = std::ranges::find(option.choices, text);
  if (found == option.choices.end())
    return wrong(
        option, fmt::format("{}: {} is {}{}, expected {}", doc_->name, option.name, in_quotes(text),
                            did_you_mean(text, option.choices), expectation(option)));
  keep(option, Choice{static_cast<std::size_t>(found - option.choices.begin())});
}

void Arguments::take_material(lua_State* L, int index, const Option& option) {
  if (const Material* material = object_at<Material>(L, index)) return keep(option, *material);
  if (lua_type(L, index) != LUA_TSTRING) return wrong_type(L, index, option);
  try {
    keep(option, session_of(L).materials().find(text_at(L, index)).material);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::refused) throw;
    const Problem& problem = error.problems().front();
    wrong(option, fmt::format("{}: {}", doc_->name, problem.what), problem.remedy);
  }
}

std::string Arguments::full_name(const Option& option) const {
  return fmt::format("{}: {}", doc_->name, option.name);
}

void Arguments::take_vector_field(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) != LUA_TFUNCTION) {
    take_point(L, index, option);
    if (has(option.name)) keep(option, VectorField(point(option.name)));
    return;
  }
  keep(option,
       VectorField([function = LuaFunction(L, index, full_name(option))](const Vec2& place) {
         Vec2 value{0, 0};
         function.call({place.data(), 2}, {value.data(), 2}, at_place(place));
         return value;
       }));
}

void Arguments::take_scalar_field(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) != LUA_TFUNCTION) {
    take_number(L, index, option);
    if (has(option.name)) keep(option, ScalarField(number(option.name)));
    return;
  }
  keep(option,
       ScalarField([function = LuaFunction(L, index, full_name(option))](const Vec2& place) {
         double value = 0.0;
         function.call({place.data(), 2}, {&value, 1}, at_place(place));
         return value;
       }));
}

void Arguments::take_function(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) != LUA_TFUNCTION) return wrong_type(L, index, option);
  keep(option, LuaFunction(L, index, full_name(option)));
}

void Arguments::take_course(lua_State* L, int index, const Option& option) {
  if (lua_type(L, index) == LUA_TFUNCTION) {
    const LuaFunction function(L, index, full_name(option));
    return keep(
        option,
        Course(
            [function](double t) {
              double factor = 0.0;
              function.call({&t, 1}, {&factor, 1}, fmt::format("at t = {}", quantity(t, "s")));
              return factor;
            },
            function.text()));
  }
  if (lua_type(L, index) != LUA_TTABLE) return wrong_type(L, index, option);
  const auto points = points_at(L, index);
  if (!points || points->empty())
    return wrong(option, fmt::format("{} is not a list of pairs, expected {}", full_name(option),
                                     expectation(option)));
  Problems found;
  check(Course(*points), full_name(option), found);
  for (const Problem& problem : found.list()) wrong(option, problem.what, problem.remedy);
  if (found.empty()) keep(option, Course(*points));
}

void Arguments::wrong(const Option& option, std::string what, std::string remedy) {
  slots_[static_cast<std::size_t>(&option - doc_->options.data())].bad = true;
  problems.add(std::move(what), std::move(remedy));
}

void Arguments::wrong_type(lua_State* L, int index, const Option& option) {
  wrong(option, fmt::format("{}: {} is {}, expected {}", doc_->name, option.name,
                            description(L, index), expectation(option)));
}

void Arguments::keep(const Option& option, Value value) {
  slots_[static_cast<std::size_t>(&option - doc_->options.data())].value = std::move(value);
}

const Arguments::Slot& Arguments::at(std::string_view name) const {
  const Option* option = find_option(*doc_, name);
  assert(option != nullptr);
  return slots_[static_cast<std::size_t>(option - doc_->options.data())];
}

bool Arguments::good(std::initializer_list<std::string_view> names) const {
  return std::ranges::none_of(names, [this](std::string_view name) { return at(name).bad; });
}

double Arguments::number(std::string_view name, double fallback) const {
  return value_or(name, fallback);
}

std::int64_t Arguments::integer(std::string_view name, std::int64_t fallback) const {
  return value_or(name, fallback);
}

std::string Arguments::text(std::string_view name, std::string_view fallback) const {
  return value_or(name, std::string(fallback));
}

std::string Arguments::text_of_choice(std::string_view name, std::string_view fallback) const {
  if (!has(name)) return std::string(fallback);
  return std::string(find_option(*doc_, name)->choices[value_or(name, Choice{}).index]);
}

bool Arguments::flag(std::string_view name, bool fallback) const {
  return value_or(name, fallback);
}

Vec2 Arguments::point(std::string_view name) const {
  return value_or(name, Vec2(0.0, 0.0));
}

Vec2 Arguments::pair(std::string_view name, const Vec2& fallback) const {
  return value_or(name, fallback);
}

Eigen::Vector3d Arguments::window(std::string_view name) const {
  return value_or(name, Eigen::Vector3d{0.0, 0.0, 0.0});
}

std::vector<std::string> Arguments::texts(std::string_view name) const {
  return value_or(name, std::vector<std::string>{});
}

std::vector<Vec2> Arguments::points(std::string_view name) const {
  return value_or(name, std::vector<Vec2>{});
}

std::vector<Marker> Arguments::markers(std::string_view name) const {
  return value_or(name, std::vector<Marker>{});
}

std::vector<double> Arguments::numbers(std::string_view name) const {
  return value_or(name, std::vector<double>{});
}

std::vector<std::shared_ptr<Recording>> Arguments::recordings(std::string_view name) const {
  return value_or(name, std::vector<std::shared_ptr<Recording>>{});
}

Material Arguments::material(std::string_view name) const {
  return value_or(name, Material{});
}

VectorField Arguments::vector_field(std::string_view name) const {
  return value_or(name, VectorField{Vec2(0.0, 0.0)});
}

ScalarField Arguments::scalar_field(std::string_view name) const {
  return value_or(name, ScalarField{0.0});
}

Course Arguments::course(std::string_view name) const {
  return value_or(name, Course{});
}

LuaFunction Arguments::function(std::string_view name) const {
  return std::get<LuaFunction>(at(name).value.value());
}

}  // namespace hackle
