// SPDX-License-Identifier: MIT
#include "console/reference/raw_value.hpp"

#include "console/lua/lua_tokens.hpp"
#include "console/reference/vocabulary.hpp"
#include "console/schema/object_type.hpp"

namespace hackle {
namespace {

constexpr int longest_chain = 8;  // of tables behind __index; a chain may be circular

// [-0, +0 or +1] Pushes the table behind __index of the value on top, if there is one.
bool push_behind(lua_State* L) {
  luaL_checkstack(L, 4, "tables too deep");
  if (luaL_getmetafield(L, -1, "__index") == LUA_TNIL) return false;
  if (lua_type(L, -1) == LUA_TTABLE) return true;
  lua_pop(L, 1);
  return false;
}

// [-0, +some] Leaves on top the value of a key of the value on top.
void push_key(lua_State* L, std::string_view name) {
  for (int chain = 0; chain < longest_chain; ++chain) {
    if (lua_type(L, -1) == LUA_TTABLE) {
      push_text(L, name);
      if (lua_rawget(L, -2) != LUA_TNIL) return;
      lua_pop(L, 1);
    }
    if (!push_behind(L)) break;
  }
  lua_pushnil(L);
}

// [-0, +some]
void push_global(lua_State* L, std::string_view name) {
  lua_pushglobaltable(L);
  push_key(L, name);
}

RawValue describe_top(lua_State* L) {
  if (lua_type(L, -1) == LUA_TTABLE) return {.table = lua_gettop(L)};
  if (const TypeDoc* type = type_at(L, -1)) return {.type = type};
  if (lua_type(L, -1) == LUA_TSTRING && push_behind(L)) return {.table = lua_gettop(L)};
  return {};
}

RawValue step(lua_State* L, const RawValue& from, std::string_view name) {
  if (from.type != nullptr) {
    const Property* field = find_field(*from.type, name);
    return {.field = field != nullptr && !field->keys.empty() ? field : nullptr};
  }
  if (from.table == 0) return {};
  lua_pushvalue(L, from.table);
  push_key(L, name);
  return describe_top(L);
}

const FunctionDoc* method_of_any(std::string_view name) {
  for (const TypeDoc* type : all_types())
    if (const Function* method = find_method(*type, name)) return method->doc;
  return nullptr;
}

}  // namespace

const TypeDoc* type_at(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TUSERDATA) return nullptr;
  if (luaL_getmetafield(L, index, "__metatable") == LUA_TNIL) return nullptr;
  const char* text = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
  const TypeDoc* type = find_type(text);
  lua_pop(L, 1);
  return type;
}

const FunctionDoc* doc_of_global(lua_State* L, int index) {
  const lua_CFunction function = lua_tocfunction(L, index);
  for (const Function& known : all_functions())
    if (known.call == function) return known.doc;
  return nullptr;
}

RawValue raw_value(lua_State* L, const NamePath& path) {
  luaL_checkstack(L, 4, "a long path");
  push_global(L, path.names.front());
  RawValue value = describe_top(L);
  for (std::size_t k = 1; k < path.names.size(); ++k) value = step(L, value, path.names[k]);
  return value;
}

const FunctionDoc* doc_of(lua_State* L, const NamePath& path) {
  if (path.names.size() == 1) {
    push_global(L, path.names.front());
    return doc_of_global(L, -1);
  }
  NamePath object = path;
  object.names.pop_back();
  const RawValue value = raw_value(L, object);
  if (!value.known() && path.is_method) return method_of_any(path.names.back());
  if (value.type != nullptr) {
    const Function* method = find_method(*value.type, path.names.back());
    return method != nullptr ? method->doc : nullptr;
  }
  if (value.table == 0) return nullptr;
  lua_pushvalue(L, value.table);
  push_key(L, path.names.back());
  return doc_of_global(L, -1);
}

std::vector<Key> keys_of(lua_State* L, int table) {
  std::vector<Key> keys;
  lua_pushvalue(L, table);
  for (int chain = 0; chain < longest_chain; ++chain) {
    for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
      if (lua_type(L, -2) != LUA_TSTRING) continue;
      const std::string_view name = lua_tostring(L, -2);
      if (is_lua_name(name)) keys.push_back({name, lua_isfunction(L, -1)});
    }
    if (!push_behind(L)) break;
  }
  return keys;
}

}  // namespace hackle
