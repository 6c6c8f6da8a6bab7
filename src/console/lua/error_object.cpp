// SPDX-License-Identifier: MIT
#include "console/lua/error_object.hpp"

#include <string_view>
#include <utility>
#include <vector>

namespace hackle {
namespace {

std::string_view kind_name(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::run_failed:
      return "run_failed";
    case ErrorKind::usage:
      return "usage";
    case ErrorKind::script:
      return "script";
    case ErrorKind::refused:
      return "refused";
    case ErrorKind::files:
      return "files";
    case ErrorKind::interrupted:
      return "interrupted";
  }
  return "?";
}

int error_to_text(lua_State* L) {
  push_text(L, object_at<Error>(L, 1)->what());
  return 1;
}

int error_concat(lua_State* L) {
  luaL_tolstring(L, 1, nullptr);
  luaL_tolstring(L, 2, nullptr);
  lua_concat(L, 2);
  return 1;
}

int error_index(lua_State* L) {
  const Error& error = *object_at<Error>(L, 1);
  const std::string_view key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
  if (key == "kind")
    push_text(L, kind_name(error.kind()));
  else if (key == "message")
    push_text(L, error.what());
  else
    lua_pushnil(L);
  return 1;
}

// Gives every error value a text while the protected call is still active. Keeps strings and error
// objects.
int with_text(lua_State* L) {
  if (lua_type(L, 1) == LUA_TSTRING || object_at<Error>(L, 1) != nullptr) return 1;
  if (luaL_callmeta(L, 1, "__tostring") && lua_type(L, -1) == LUA_TSTRING) return 1;
  lua_pushfstring(L, "(error object is a %s value)", luaL_typename(L, 1));
  return 1;
}

}  // namespace

void open_errors(lua_State* L) {
  luaL_newmetatable(L, type_name<Error>);
  const luaL_Reg functions[] = {{"__gc", destroy_object<Error>},
                                {"__tostring", error_to_text},
                                {"__concat", error_concat},
                                {"__index", error_index},
                                {nullptr, nullptr}};
  luaL_setfuncs(L, functions, 0);
  lua_pushliteral(L, "error");
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 1);
}

std::string place(lua_State* L, int level) {
  lua_Debug frame;
  if (lua_getstack(L, level, &frame) == 0) return "";
  lua_getinfo(L, "Sl", &frame);
  if (frame.currentline <= 0 || std::string_view(frame.source) == prompt_chunk) return "";
  return std::string(frame.short_src) + ":" + std::to_string(frame.currentline) + ": ";
}

void push_error(lua_State* L, const Error& error, const std::string& place) {
  std::vector<Problem> problems = error.problems();
  for (Problem& problem : problems) problem.what.insert(0, place);
  push_object(L, Error(error.kind(), std::move(problems)));
}

void protected_call(lua_State* L, int arguments, int results) {
  const int handler = lua_gettop(L) - arguments;
  lua_pushcfunction(L, with_text);
  lua_insert(L, handler);
  const int status = lua_pcall(L, arguments, results, handler);
  lua_remove(L, handler);
  if (status != LUA_OK) throw take_error(L);
}

void protect(lua_State* L, const std::function<void(lua_State*)>& work) {
  lua_pushcfunction(L, [](lua_State* inner) {
    (*static_cast<const std::function<void(lua_State*)>*>(lua_touserdata(inner, 1)))(inner);
    return 0;
  });
  lua_pushlightuserdata(L, const_cast<void*>(static_cast<const void*>(&work)));
  protected_call(L, 1, 0);
}

Error take_error(lua_State* L) {
  Error error(ErrorKind::script, "");
  if (const Error* ours = object_at<Error>(L, -1))
    error = *ours;
  else if (const char* text = lua_tostring(L, -1))
    error = std::string_view(text).ends_with("not enough memory") ? out_of_memory(L)
                                                                  : Error(ErrorKind::script, text);
  else
    error = Error(ErrorKind::script, "(error without a text)");
  lua_pop(L, 1);
  return error;
}

}  // namespace hackle
