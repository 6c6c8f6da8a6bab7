// SPDX-License-Identifier: MIT
#include "console/schema/arguments.hpp"

#include <algorithm>
#include <cassert>
#include <set>

#include <fmt/format.h>

#include "base/text.hpp"
#include "console/lua/description.hpp"

namespace hackle {
namespace {

std::vector<std::string_view> names_of(const FunctionDoc& doc) {
  std::vector<std::string_view> names;
  for (const Option& option : doc.options) names.push_back(option.name);
  return names;
}

const Option* find_positional(const FunctionDoc& doc) {
  const auto found = std::ranges::find(doc.options, true, &Option::positional);
  return found == doc.options.end() ? nullptr : &*found;
}

}  // namespace

Arguments Arguments::from_table(lua_State* L, int index, const FunctionDoc& doc) {
  Arguments arguments(doc);
  const Option* positional = find_positional(doc);
  if (lua_type(L, index) == LUA_TSTRING && positional != nullptr)
    arguments.take(L, index, *positional);
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
    if (!lua_isnoneornil(L, at)) arguments.take(L, at, option);
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

// Reads known options in their order, then reports unknown ones by name: the order of a Lua table
// differs from process to process, and messages must not.
void Arguments::read_table(lua_State* L, int index) {
  for (const Option& option : doc_->options) {
    lua_pushlstring(L, option.name.data(), option.name.size());
    if (lua_rawget(L, index) != LUA_TNIL) take(L, lua_gettop(L), option);
    lua_pop(L, 1);
  }
  const Option* positional = find_positional(*doc_);
  if (positional != nullptr) read_positional(L, index, *positional);
  const auto rest = std::ranges::find(doc_->options, true, &Option::rest);
  if (rest != doc_->options.end()) read_rest(L, index, *rest);
  const bool has_rest = rest != doc_->options.end();
  const auto listed = static_cast<lua_Integer>(lua_rawlen(L, index));
  report_others(L, index, has_rest ? listed : positional != nullptr ? 1 : 0);
}

void Arguments::read_positional(lua_State* L, int index, const Option& option) {
  if (lua_rawgeti(L, index, 1) != LUA_TNIL) {
    if (has(option.name) || at(option.name).bad)
      problems.add(fmt::format("{}: {} is given twice", doc_->name, option.name));
    else
      take(L, lua_gettop(L), option);
  }
  lua_pop(L, 1);
}

// Takes the entries from [2] on as a list.
void Arguments::read_rest(lua_State* L, int index, const Option& option) {
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, index));
  if (count < 2) return;
  if (has(option.name) || at(option.name).bad) {
    problems.add(fmt::format("{}: {} is given twice", doc_->name, option.name));
    return;
  }
  lua_createtable(L, static_cast<int>(std::min<lua_Integer>(count, 1 << 16)), 0);
  for (lua_Integer k = 2; k <= count; ++k) {
    lua_rawgeti(L, index, k);
    lua_rawseti(L, -2, k - 1);
  }
  take(L, lua_gettop(L), option);
  lua_pop(L, 1);
}

// Entries without a name are known up to [known].
void Arguments::report_others(lua_State* L, int index, lua_Integer known) {
  std::set<std::string> unknown, nameless;
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
    const bool named = lua_type(L, -2) == LUA_TSTRING;
    const lua_Integer place = lua_isinteger(L, -2) ? lua_tointeger(L, -2) : 0;
    if (named && find_option(*doc_, text_at(L, -2)) == nullptr) unknown.emplace(text_at(L, -2));
    if (!named && !(place >= 1 && place <= known)) nameless.insert(description(L, -1));
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
  const auto given = [&](std::string_view name) {
    return !name.empty() && (has(name) || at(name).bad);
  };
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    const Option& option = doc_->options[k];
    if (!option.required || given(option.unless) || given(option.name)) continue;
    slots_[k].bad = true;
    problems.add(fmt::format("{}: {} is missing", doc_->name, option.name), expectation(option));
  }
}

void Arguments::take(lua_State* L, int index, const Option& option) {
  Slot& slot = slots_[static_cast<std::size_t>(&option - doc_->options.data())];
  slot.value = read_value({L, index, *doc_, option, problems});
  slot.bad = !slot.value.has_value();
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

std::vector<double> Arguments::numbers(std::string_view name) const {
  return value_or(name, std::vector<double>{});
}

LuaFunction Arguments::function(std::string_view name) const {
  return std::any_cast<const LuaFunction&>(at(name).value);
}

}  // namespace hackle
