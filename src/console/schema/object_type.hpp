// SPDX-License-Identifier: MIT
// Makes types and functions of the scene language known to Lua.
#pragma once

#include <span>
#include <string_view>

#include "console/lua/guard.hpp"
#include "console/schema/schema.hpp"

namespace hackle {

// Makes the metatable of a type: its methods and fields, a suggestion for an unknown name, its
// text, and protection against writing and against access to the metatable from a script.
void open_type(lua_State* L, const char* registry_name, const TypeDoc& type);

// Defines the functions as globals, those with a dot in their name in a table.
void open_functions(lua_State* L, std::span<const Function> functions);

// Throws the Error for a method called without its object, as in p.crack{...}.
[[noreturn]] void refuse_self(const FunctionDoc& doc);

// Returns the object that a method was called on.
template <class T>
T& self(lua_State* L, const FunctionDoc& doc) {
  T* object = object_at<T>(L, 1);
  if (object == nullptr) refuse_self(doc);
  return *object;
}

}  // namespace hackle
