// SPDX-License-Identifier: MIT
#include "console/lua/lua_function.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "console/lua/description.hpp"
#include "console/lua/error_object.hpp"
#include "console/lua/interrupt_hook.hpp"

namespace hackle {

// Lives as long as the state.
using Life = std::shared_ptr<const bool>;
template <>
inline constexpr const char* type_name<Life> = "hackle.life";

namespace {

constexpr const char* life_key = "hackle.life of this state";

std::weak_ptr<const bool> life_of(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, life_key);
  const Life* life = object_at<Life>(L, -1);
  std::weak_ptr<const bool> observed;
  if (life != nullptr) observed = *life;
  lua_pop(L, 1);
  return observed;
}

lua_State* main_thread(lua_State* L) {
  lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_MAINTHREAD);
  lua_State* main = lua_tothread(L, -1);
  lua_pop(L, 1);
  return main;
}

std::string where_defined(lua_State* L, int index) {
  lua_Debug function;
  lua_pushvalue(L, index);
  lua_getinfo(L, ">S", &function);
  if (function.linedefined <= 0) return "function";
  return fmt::format("function at {}:{}", function.short_src, function.linedefined);
}

int parameters_of(lua_State* L, int index) {
  lua_Debug function;
  lua_pushvalue(L, index);
  lua_getinfo(L, ">u", &function);
  return function.nparams;
}

}  // namespace

// Of a function that gives a value: seconds, where the run needs one at every step.
constexpr long most_instructions = 200'000'000;

struct LuaFunction::Reference {
  Reference(lua_State* L, int index) : state(main_thread(L)), life(life_of(L)) {
    lua_pushvalue(L, index);
    place = luaL_ref(L, LUA_REGISTRYINDEX);
  }
  ~Reference() {
    if (!life.expired()) luaL_unref(state, LUA_REGISTRYINDEX, place);
  }
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;

  lua_State* state;
  std::weak_ptr<const bool> life;
  int place = LUA_NOREF;
};

LuaFunction::LuaFunction(lua_State* L, int index, std::string who)
    : reference_(std::make_shared<const Reference>(L, index)),
      who_(std::move(who)),
      text_(where_defined(L, index)),
      parameters_(parameters_of(L, index)) {
}

void LuaFunction::call(std::span<const double> arguments, std::span<double> results,
                       const std::string& where) const {
  lua_State* L = reference_->state;
  const int top = lua_gettop(L);
  luaL_checkstack(L, static_cast<int>(arguments.size() + results.size()) + 3, nullptr);
  lua_rawgeti(L, LUA_REGISTRYINDEX, reference_->place);
  for (const double argument : arguments) lua_pushnumber(L, argument);
  const CallLimit limit(results.empty() ? 0 : most_instructions);
  try {
    protected_call(L, static_cast<int>(arguments.size()), static_cast<int>(results.size()));
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted) throw;
    throw Error(
        error.kind(),
        fmt::format("{}: the function fails {}: {}", who_, where, error.problems().front().what),
        error.problems().front().remedy);
  }
  for (std::size_t k = 0; k < results.size(); ++k) {
    const int index = top + 1 + static_cast<int>(k);
    const bool number = lua_type(L, index) == LUA_TNUMBER;
    results[k] = number ? lua_tonumber(L, index) : std::nan("");
    if (std::isfinite(results[k])) continue;
    const std::string got = description(L, index);
    lua_settop(L, top);
    throw Error(ErrorKind::refused, fmt::format("{}: the function returns {} {}", who_, got, where),
                results.size() == 1 ? "it must return a finite number"
                                    : "it must return two finite numbers");
  }
  lua_settop(L, top);
}

void open_kept_functions(lua_State* L) {
  luaL_newmetatable(L, type_name<Life>);
  lua_pushcfunction(L, destroy_object<Life>);
  lua_setfield(L, -2, "__gc");
  lua_pop(L, 1);
  push_object(L, Life(std::make_shared<const bool>(true)));
  lua_setfield(L, LUA_REGISTRYINDEX, life_key);
}

}  // namespace hackle
