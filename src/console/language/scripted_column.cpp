// SPDX-License-Identifier: MIT
#include "console/language/scripted_column.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"
#include "console/language/gauge_binding.hpp"
#include "console/lua/description.hpp"
#include "scene/load_names.hpp"

namespace hackle {
namespace {

// [-0, +1] Calls the function in the first upvalue with the object in the weak table in the second.
int call_with_object(lua_State* L) {
  lua_settop(L, 0);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_rawgeti(L, lua_upvalueindex(2), 1);
  lua_call(L, 1, 1);
  return 1;
}

void push_weakly(lua_State* L, int index) {
  lua_createtable(L, 1, 0);
  lua_pushvalue(L, index);
  lua_rawseti(L, -2, 1);
  lua_createtable(L, 0, 1);
  push_text(L, "v");
  lua_setfield(L, -2, "__mode");
  lua_setmetatable(L, -2);
}

LuaFunction with_object(lua_State* L, int index, const std::string& who) {
  const int function = lua_absindex(L, index);
  lua_pushvalue(L, function);
  push_weakly(L, 1);
  lua_pushcclosure(L, call_with_object, 2);
  LuaFunction bound(L, lua_gettop(L), who);
  lua_pop(L, 1);
  return bound;
}

// Reads {name = function, ...} at the top of the stack, ordered by name. Returns what is wrong.
std::string read_named(const GivenValue& given, ScriptedColumns& columns) {
  lua_State* L = given.L;
  const int table = lua_gettop(L);
  const std::size_t before = columns.size();
  std::string wrong;
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING || lua_type(L, -1) != LUA_TFUNCTION) {
      wrong = "holds something that is not name = function";
      continue;
    }
    const std::string name(text_at(L, -2));
    if (!is_identifier(name))
      wrong = fmt::format("has the name {}: letters, digits and _ make one", in_quotes(name));
    columns.push_back({name, with_object(L, -1, fmt::format("{}: {}", given.doc.name, name))});
  }
  if (columns.size() == before && wrong.empty()) wrong = "is empty";
  std::sort(columns.begin() + static_cast<std::ptrdiff_t>(before), columns.end(),
            [](const auto& one, const auto& other) { return one.name < other.name; });
  return wrong;
}

// Reads the entry at the top of the stack. Returns what is wrong, or "".
std::string read_column(const GivenValue& given, ScriptedColumns& columns) {
  lua_State* L = given.L;
  const int top = lua_gettop(L);
  switch (lua_type(L, top)) {
    case LUA_TSTRING:
      columns.push_back({std::string(text_at(L, top))});
      return "";
    case LUA_TFUNCTION: {
      const std::string name = fmt::format("value{}", columns.size() + 1);
      columns.push_back({name, with_object(L, top, fmt::format("{}: {}", given.doc.name, name))});
      return "";
    }
    case LUA_TUSERDATA:
      if (const auto* scripted = object_at<ScriptedGauge>(L, top)) {
        columns.push_back({scripted->gauge->name, {}, *scripted->gauge});
        return "";
      }
      return fmt::format("is {}", description(L, top));
    case LUA_TTABLE:
      return read_named(given, columns);
    default:
      return fmt::format("is {}", description(L, top));
  }
}

double value_of(const LuaFunction& function, const View& view) {
  double value = 0.0;
  function.call({}, {&value, 1}, fmt::format("at t = {}", quantity(view.time(), "s")));
  return value;
}

Column column_of_function(const ScriptedColumn& given) {
  return {given.name, "", [call = *given.function](Glance& glance) -> std::optional<double> {
            return value_of(call, glance.view());
          }};
}

Column column_of_event(const ScriptedColumn& given, const Run& run, Replay& replay) {
  const LuaFunction function = *given.function;
  const std::uint64_t listener =
      replay.enlist([function, &run] { value_of(function, run.simulation()); });
  return {given.name, "",
          [function, listener, &run, &replay](Glance& glance) -> std::optional<double> {
            const Replay::Event event(replay, listener, run);
            return value_of(function, glance.view());
          }};
}

Column column_of(const ScriptedColumn& given, const View& view, bool of_run) {
  if (!given.gauge) return column_named(given.name, view, of_run, "log");
  check_on(*given.gauge, view, "log");
  return column_of(*given.gauge);
}

}  // namespace

std::any read_columns(const GivenValue& given) {
  lua_State* L = given.L;
  if (!given.is_list()) return {};
  ScriptedColumns columns;
  for (lua_Unsigned k = 1; k <= lua_rawlen(L, given.index); ++k) {
    lua_rawgeti(L, given.index, static_cast<lua_Integer>(k));
    const std::string wrong = read_column(given, columns);
    lua_pop(L, 1);
    if (!wrong.empty())
      return given.wrong(fmt::format("{}: column {} {}", given.doc.name, k, wrong),
                         fmt::format("expected {}", expectation(given.option)));
  }
  return columns;
}

std::vector<Column> columns_of(const ScriptedColumns& given, const View& view) {
  std::vector<Column> columns;
  for (const ScriptedColumn& one : given)
    columns.push_back(one.function ? column_of_function(one) : column_of(one, view, false));
  return columns;
}

std::vector<Column> columns_of(const ScriptedColumns& given, const Run& run, Replay* replay) {
  std::vector<Column> columns;
  for (const ScriptedColumn& one : given)
    columns.push_back(!one.function       ? column_of(one, run.simulation(), true)
                      : replay != nullptr ? column_of_event(one, run, *replay)
                                          : column_of_function(one));
  return columns;
}

}  // namespace hackle
