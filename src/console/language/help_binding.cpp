// SPDX-License-Identifier: MIT
#include "console/language/help_binding.hpp"

#include <array>
#include <string>

#include "console/lua/guard.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

constexpr FunctionDoc help_doc{.name = "help",
                               .leading = "what",
                               .call = Call::free,
                               .sentence =
                                   "Explains a function, an option, an object or a word, and "
                                   "searches for any other words; without one it gives a tour.",
                               .example = "help \"crack\""};

int help(lua_State* L) {
  const std::string text = session_of(L).help_on(L);
  const auto& page = session_of(L).settings.page;
  if (page) {
    page(text);
    return 0;
  }
  lua_getglobal(L, "print");
  push_text(L, text);
  lua_call(L, 1, 0);
  return 0;
}

}  // namespace

std::span<const Function> help_functions() {
  static constexpr std::array functions{Function{&help_doc, guarded<help>}};
  return functions;
}

}  // namespace hackle
