// SPDX-License-Identifier: MIT
// C++ values that live in Lua as full userdata.
#pragma once

#include <new>
#include <string_view>
#include <utility>

#include "console/lua/lua_state.hpp"

namespace hackle {

// The registry name of a type, "hackle.plate". Each bound type specialises it beside its
// definition.
template <class T>
inline constexpr const char* type_name = nullptr;

inline constexpr std::string_view type_prefix = "hackle.";

// [-0, +1] Moves a value into Lua, whose collector destroys it. All that may run out of memory
// comes before the move: the collector does not destroy what has no metatable yet.
template <class T>
T& push_object(lua_State* L, T value) {
  static_assert(type_name<T> != nullptr && alignof(T) <= alignof(lua_Number));
  luaL_getmetatable(L, type_name<T>);
  T* object = new (lua_newuserdatauv(L, sizeof(T), 0)) T(std::move(value));
  lua_insert(L, -2);
  lua_setmetatable(L, -2);
  return *object;
}

// [-0, +0] Returns the object at `index`, or null for any other value.
template <class T>
T* object_at(lua_State* L, int index) {
  return static_cast<T*>(luaL_testudata(L, index, type_name<T>));
}

// Destroys the value; anything that still holds the object, such as a finalizer of a script, then
// finds no value.
template <class T>
int destroy_object(lua_State* L) {
  T* object = object_at<T>(L, 1);
  if (object == nullptr) return 0;
  lua_pushnil(L);
  lua_setmetatable(L, 1);
  object->~T();
  return 0;
}

}  // namespace hackle
