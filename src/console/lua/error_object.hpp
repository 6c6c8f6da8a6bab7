// SPDX-License-Identifier: MIT
// An Error in Lua, and calls of Lua that throw one.
#pragma once

#include <functional>
#include <string>

#include "base/error.hpp"
#include "console/lua/object.hpp"

namespace hackle {

// An error object is an Error in Lua, each problem beginning with "file:line: " of the caller. In a
// script: tostring(e), "text" .. e, e.kind ("refused"), e.message.
template <>
inline constexpr const char* type_name<Error> = "hackle.error";

void open_errors(lua_State* L);

// "file:line: " of the function at `level` of the call stack (0 runs, 1 called it), or "" when it
// is not Lua or was typed at the prompt.
std::string place(lua_State* L, int level);

// The name of chunks whose errors need no place.
inline constexpr const char* prompt_chunk = "=prompt";

// [-0, +1] Pushes an error object with a place before each problem.
void push_error(lua_State* L, const Error& error, const std::string& place);

// [-(arguments + 1), +results] lua_pcall that throws Error: the one of an error object, or kind
// `script` with the message of any other. On failure nothing is left on the stack.
void protected_call(lua_State* L, int arguments, int results);

// [-0, +0] Calls functions of Lua that may raise an error, on a stack of its own. Throws Error.
void protect(lua_State* L, const std::function<void(lua_State*)>& work);

// [-1, +0] The error value on top of the stack as an Error.
Error take_error(lua_State* L);

}  // namespace hackle
