// SPDX-License-Identifier: MIT
#include "console/help_binding.hpp"

#include <array>
#include <string>

#include "console/arguments.hpp"
#include "console/reference.hpp"

namespace hackle {
namespace {

constexpr FunctionDoc help_doc{.name = "help",
                               .leading = "what",
                               .call = Call::free,
                               .sentence = "Tells about a function, a type or all of them.",
                               .example = "help \"crack\""};

std::string help_on_function(lua_CFunction function) {
  for (const Function& known : all_functions())
    if (known.call == function) return reference_of(*known.doc);
  for (const TypeDoc* type : all_types())
    for (const Function& method : type->methods)
      if (method.call == function) return reference_of(*method.doc);
  throw Error(ErrorKind::refused, "help: this function is not one of Hackle's",
              "help() lists everything");
}

std::string help_on(lua_State* L) {
  if (lua_isnoneornil(L, 1)) return overview();
  if (lua_iscfunction(L, 1)) return help_on_function(lua_tocfunction(L, 1));
  if (lua_type(L, 1) == LUA_TSTRING) return reference_of(lua_tostring(L, 1));
  // Objects of ours name their type here.
  if (lua_type(L, 1) == LUA_TUSERDATA && luaL_getmetafield(L, 1, "__metatable") == LUA_TSTRING)
    return reference_of(lua_tostring(L, -1));
  throw Error(ErrorKind::refused, "help: nothing is known of " + description(L, 1),
              "help() lists everything");
}

int help(lua_State* L) {
  const std::string text = help_on(L);
  lua_getglobal(L, "print");
  push_text(L, text);
  lua_call(L, 1, 0);
  return 0;
}

constexpr std::array functions{Function{&help_doc, guarded<help>}};

}  // namespace

std::span<const Function> help_functions() {
  return functions;
}

}  // namespace hackle
