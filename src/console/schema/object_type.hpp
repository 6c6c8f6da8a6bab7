// SPDX-License-Identifier: MIT
// How types and functions of the scene language become known to Lua.
#pragma once

#include <span>
#include <string_view>

#include "console/lua/guard.hpp"
#include "console/schema/schema.hpp"

namespace hackle {

// Makes the metatable of a type: its methods and fields, a suggestion for a name it does not have,
// its text, and no way to write to it or to reach the metatable from a script.
void open_type(lua_State* L, const char* registry_name, const TypeDoc& type);

// Makes the functions global.
void open_functions(lua_State* L, std::span<const Function> functions);

// Throws the Error for a method that was called without its object, as in p.crack{...}.
[[noreturn]] void refuse_self(const FunctionDoc& doc);

// The object that a method was called on.
template <class T>
T& self(lua_State* L, const FunctionDoc& doc) {
  T* object = object_at<T>(L, 1);
  if (object == nullptr) refuse_self(doc);
  return *object;
}

}  // namespace hackle
