// SPDX-License-Identifier: MIT
#include "console/language/scripted_source.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "console/language/scripted_recording.hpp"
#include "console/language/scripted_run.hpp"
#include "console/lua/description.hpp"
#include "console/lua/object.hpp"

namespace hackle {
namespace {

// Returns the list of numbers at the top of the stack; nothing for anything else.
std::optional<std::vector<double>> numbers_at_top(lua_State* L) {
  if (lua_type(L, -1) != LUA_TTABLE) return std::nullopt;
  const int list = lua_gettop(L);
  std::vector<double> values;
  for (lua_Unsigned k = 1; k <= lua_rawlen(L, list); ++k) {
    const bool is_number = lua_rawgeti(L, list, static_cast<lua_Integer>(k)) == LUA_TNUMBER;
    values.push_back(lua_tonumber(L, -1));
    lua_pop(L, 1);
    if (!is_number) return std::nullopt;
  }
  return values;
}

// Reads the table at the top of the stack. Returns what is wrong, or "".
std::string read_numbers(lua_State* L, SeriesTable& numbers) {
  const int table = lua_gettop(L);
  std::map<std::string, std::vector<double>> columns;  // in one order, whatever Lua has
  std::string wrong;
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
    const bool named = lua_type(L, -2) == LUA_TSTRING;
    const std::string key = named ? std::string(text_at(L, -2)) : "";
    if (key == "name" && lua_type(L, -1) == LUA_TSTRING)
      numbers.name = text_at(L, -1);
    else if (auto values = numbers_at_top(L); named && values)
      columns[key] = std::move(*values);
    else
      wrong = "holds something that is no list of numbers with a name";
  }
  const std::size_t rows = columns.empty() ? 0 : columns.begin()->second.size();
  for (auto& [heading, values] : columns) {
    if (values.size() != rows) wrong = "has lists of different lengths";
    numbers.headings.push_back(heading);
    numbers.columns.push_back(std::move(values));
  }
  if (columns.empty() && wrong.empty()) wrong = "is empty";
  return wrong;
}

// Reads the entry at the top of the stack. Returns what is wrong, or "".
std::string read_source(lua_State* L, ScriptedSources& sources) {
  if (lua_type(L, -1) == LUA_TSTRING) {
    sources.emplace_back(std::filesystem::path(std::string(text_at(L, -1))));
    return "";
  }
  if (const auto* scripted = object_at<ScriptedRecording>(L, -1)) {
    sources.emplace_back(scripted->recording);
    return "";
  }
  if (const auto* scripted = object_at<ScriptedRun>(L, -1)) {
    scripted->results();
    sources.emplace_back(&scripted->run());
    return "";
  }
  if (lua_type(L, -1) != LUA_TTABLE)
    return "is neither a file, a recording, a simulation nor numbers";
  SeriesTable numbers{fmt::format("curve {}", sources.size() + 1), {}, {}};
  std::string wrong = read_numbers(L, numbers);
  sources.emplace_back(std::move(numbers));
  return wrong;
}

}  // namespace

std::any read_sources(const GivenValue& given) {
  lua_State* L = given.L;
  if (!given.is_list()) return {};
  ScriptedSources sources;
  for (lua_Unsigned k = 1; k <= lua_rawlen(L, given.index); ++k) {
    lua_rawgeti(L, given.index, static_cast<lua_Integer>(k));
    const std::string wrong = read_source(L, sources);
    lua_pop(L, 1);
    if (!wrong.empty())
      return given.wrong(
          fmt::format("{}: entry {} of {} {}", given.doc.name, k, given.option.name, wrong),
          "\"run.h5\", \"run.csv\", recording \"run.h5\", or { name = \"m = 3\", load = {6, 12}, "
          "branches = {0, 2} }");
  }
  return sources;
}

}  // namespace hackle
