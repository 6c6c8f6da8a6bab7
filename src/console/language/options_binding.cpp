// SPDX-License-Identifier: MIT
#include "console/language/options_binding.hpp"

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/terminal.hpp"
#include "base/text.hpp"
#include "console/language/overrides.hpp"
#include "console/lua/description.hpp"
#include "console/lua/value_text.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/shell_value.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

constexpr FunctionDoc options_doc{
    .name = "options",
    .leading = "{ name = default, ... }",
    .call = Call::free,
    .sentence = "Returns these defaults, overridden by --set name=value on the command line.",
    .example = "o = options { load = 12*MPa, film = true, name = \"crack\" }"};

// Checks that names are text, and defaults numbers, text, true or false.
void check_defaults(lua_State* L, Problems& problems) {
  for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) {
      problems.add(
          fmt::format("options: {} stands in the braces without a name", description(L, -1)));
      continue;
    }
    const int type = lua_type(L, -1);
    if (type != LUA_TNUMBER && type != LUA_TSTRING && type != LUA_TBOOLEAN)
      problems.add(fmt::format("options: {} is {}", lua_tostring(L, -2), description(L, -1)),
                   "a default is a number, a text, true or false");
  }
}

// Returns the names sorted: the order of a Lua table differs from process to process.
std::set<std::string> declare(lua_State* L, Session& session) {
  std::set<std::string> names;
  for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) {
    names.emplace(lua_tostring(L, -2));
    const std::string written = option_expression(session.origin.script_text, lua_tostring(L, -2));
    session.declared_options.emplace(lua_tostring(L, -2),
                                     dimension_of(written) ? written : value_text(L, -1));
  }
  return names;
}

void check_known(const Session& session, Problems& problems) {
  std::vector<std::string_view> known;
  for (const auto& [name, fallback] : session.declared_options) known.push_back(name);
  for (const auto& [key, value] : session.settings.overrides)
    if (!session.declared_options.contains(key) && !is_of_language(key))
      problems.add(fmt::format("--set {}={}: the script has no option '{}'{}", key, value, key,
                               did_you_mean(key, known)),
                   known.empty() ? "it has none" : "it has " + comma_list(known));
}

// A value has the dimension of its default, as far as both are known: a length for a stress is
// refused, a number without a unit is taken as SI, with a note.
void check_dimension(const Session& session, const std::string& key, const std::string& text,
                     Problems& problems) {
  const std::string fallback = option_expression(session.origin.script_text, key);
  const auto wanted = dimension_of(fallback), given = dimension_of(shell_expression(text));
  if (!wanted || !given || *wanted == no_dimension || *given == *wanted) return;
  if (*given != no_dimension)
    return problems.add(
        fmt::format("--set {}={}: its dimension is {}, that of the default {} is {}", key, text,
                    dimension_name(*given), fallback, dimension_name(*wanted)));
  if (session.settings.talk != Talk::quiet)
    say_note(
        fmt::format("--set {}={} is taken in SI units; the default is {}", key, text, fallback));
}

// [-0, +1] Pushes the override as a value of the type of the default at -1; nil if it cannot be
// one.
void push_override(lua_State* L, const std::string& key, const std::string& text,
                   Problems& problems) {
  const std::string given = fmt::format("--set {}={}: ", key, text);
  const int type = lua_type(L, -1);
  if (type == LUA_TSTRING) return push_text(L, text);
  if (type == LUA_TBOOLEAN && (text == "true" || text == "false"))
    return lua_pushboolean(L, text == "true");
  const std::optional<double> value =
      type == LUA_TNUMBER ? shell_number(L, text) : std::optional<double>();
  if (!value) {
    problems.add(given + (type == LUA_TNUMBER ? "not a finite number" : "not true or false"),
                 type == LUA_TNUMBER ? "units may be used, as in " + key + "=0.5mm" : "");
    return lua_pushnil(L);
  }
  // An integer stays an integer, so that a loop up to it counts in integers.
  lua_Integer whole = 0;
  if (lua_isinteger(L, -1) && lua_numbertointeger(*value, &whole))
    if (static_cast<double>(whole) == *value) return lua_pushinteger(L, whole);
  lua_pushnumber(L, *value);
}

int options(lua_State* L) {
  Session& session = session_of(L);
  if (lua_type(L, 1) != LUA_TTABLE)
    throw Error(ErrorKind::refused,
                fmt::format("options: expected defaults in braces, got {}", description(L, 1)),
                fmt::format("as in {}", options_doc.example));
  Problems problems;
  check_defaults(L, problems);
  problems.throw_if_any();
  const std::set<std::string> names = declare(L, session);
  if (session.settings.purpose == Purpose::options) session.leave(0);
  check_known(session, problems);
  lua_newtable(L);
  const int result = lua_gettop(L);
  for (const std::string& name : names) {
    lua_pushlstring(L, name.data(), name.size());
    lua_rawget(L, 1);
    const auto given = session.settings.overrides.find(name);
    if (given != session.settings.overrides.end()) {
      if (lua_type(L, -1) == LUA_TNUMBER) check_dimension(session, name, given->second, problems);
      push_override(L, name, given->second, problems);
    }
    lua_setfield(L, result, name.c_str());
    lua_settop(L, result);
  }
  problems.throw_if_any();
  return 1;
}

}  // namespace

std::span<const Function> options_functions() {
  static constexpr std::array functions{Function{&options_doc, guarded<options>}};
  return functions;
}

}  // namespace hackle
