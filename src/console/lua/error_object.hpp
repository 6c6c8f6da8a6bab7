// SPDX-License-Identifier: MIT
// Error as a Lua object, and calls of Lua that throw Error.
#pragma once

#include <functional>
#include <string>

#include "base/error.hpp"
#include "console/lua/object.hpp"

namespace hackle {

// An error object holds an Error; each problem begins with the "file:line: " of the caller. In a
// script: tostring(e), "text" .. e, e.kind ("refused"), e.message.
template <>
inline constexpr const char* type_name<Error> = "hackle.error";

void open_errors(lua_State* L);

// Returns "file:line: " of the function at `level` of the call stack (0 is running, 1 called it),
// or "" if it is not Lua or was typed at the prompt.
std::string place(lua_State* L, int level);

// The name of chunks whose errors need no place.
inline constexpr const char* prompt_chunk = "=prompt";

// [-0, +1] Pushes an error object with a place before each problem.
void push_error(lua_State* L, const Error& error, const std::string& place);

// [-(arguments + 1), +results] Like lua_pcall, but throws Error: that of an error object, or kind
// `script` with the message of any other error. On failure nothing is left on the stack.
void protected_call(lua_State* L, int arguments, int results);

// [-0, +0] Runs Lua functions that may raise an error, on a separate stack. Throws Error.
void protect(lua_State* L, const std::function<void(lua_State*)>& work);

// [-1, +0] Converts the error value on top of the stack to an Error.
Error take_error(lua_State* L);

}  // namespace hackle
