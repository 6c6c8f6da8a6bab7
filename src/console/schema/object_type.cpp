// SPDX-License-Identifier: MIT
#include "console/schema/object_type.hpp"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/renamed.hpp"
#include "base/text.hpp"
#include "console/lua/description.hpp"

namespace hackle {
namespace {

const TypeDoc& type_of_closure(lua_State* L) {
  return *static_cast<const TypeDoc*>(lua_touserdata(L, lua_upvalueindex(1)));
}

[[noreturn]] void refuse_name(const TypeDoc& type, std::string_view name) {
  std::vector<std::string_view> names;
  for (const Function& method : type.methods) names.push_back(method.doc->name);
  for (const Property& field : type.fields) names.push_back(field.name);
  const std::string what = fmt::format("{} has no '{}'", type.name, name.substr(0, 40));
  if (const auto now = renamed(type.name, name))
    throw Error(ErrorKind::refused, what, fmt::format("it is called '{}' now", *now));
  const auto near = nearest(name, names);
  throw Error(ErrorKind::refused, what,
              near ? fmt::format("did you mean '{}'?", *near)
                   : fmt::format("help '{}' tells what it has", type.name));
}

int index(lua_State* L) {
  const TypeDoc& type = type_of_closure(L);
  if (lua_type(L, 2) != LUA_TSTRING) refuse_name(type, description(L, 2));
  const std::string_view name = lua_tostring(L, 2);
  if (const Function* method = find_method(type, name)) {
    lua_pushcfunction(L, method->call);
    return 1;
  }
  if (const Property* field = find_field(type, name)) return call_replayed(L, field->push, field);
  refuse_name(type, name);
}

int refuse_to_write(lua_State* L) {
  const TypeDoc& type = type_of_closure(L);
  throw Error(ErrorKind::refused,
              fmt::format("the {} cannot be changed by an assignment", type.name),
              fmt::format("help({}) lists its methods and fields", type.name));
}

void set_closure(lua_State* L, const char* name, const TypeDoc& type, lua_CFunction function) {
  lua_pushlightuserdata(L, const_cast<TypeDoc*>(&type));
  lua_pushcclosure(L, function, 1);
  lua_setfield(L, -2, name);
}

}  // namespace

void open_type(lua_State* L, const char* registry_name, const TypeDoc& type) {
  luaL_newmetatable(L, registry_name);
  set_closure(L, "__index", type, guarded<index>);
  set_closure(L, "__newindex", type, guarded<refuse_to_write>);
  lua_pushcfunction(L, type.to_text);
  lua_setfield(L, -2, "__tostring");
  lua_pushcfunction(L, type.destroy);
  lua_setfield(L, -2, "__gc");
  push_text(L, type.name);
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 1);
}

void open_functions(lua_State* L, std::span<const Function> functions) {
  for (const Function& function : functions) {
    const std::string name(function.doc->name);
    const std::size_t dot = name.find('.');
    const int top = lua_gettop(L);
    lua_pushglobaltable(L);
    if (dot != std::string::npos) luaL_getsubtable(L, -1, name.substr(0, dot).c_str());
    lua_pushcfunction(L, function.call);
    lua_setfield(L, -2, name.substr(dot == std::string::npos ? 0 : dot + 1).c_str());
    lua_settop(L, top);
  }
}

void refuse_self(const FunctionDoc& doc) {
  throw Error(ErrorKind::script, fmt::format("{}: it is called with a colon", doc.name),
              fmt::format("as in {}", doc.example));
}

}  // namespace hackle
