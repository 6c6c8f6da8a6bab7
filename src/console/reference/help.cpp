// SPDX-License-Identifier: MIT
#include "console/reference/help.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.hpp"
#include "console/lua/description.hpp"
#include "console/reference/raw_value.hpp"
#include "console/reference/reference.hpp"
#include "console/reference/search.hpp"
#include "console/reference/tour.hpp"
#include "console/reference/vocabulary.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

std::string help_on_function(lua_CFunction function) {
  for (const Function& known : all_functions())
    if (known.call == function) return reference_of(*known.doc);
  for (const TypeDoc* type : all_types())
    for (const Function& method : type->methods)
      if (method.call == function) return reference_of(*method.doc);
  throw Error(ErrorKind::refused, "help: this function is not one of Hackle's",
              "help \"functions\" lists Hackle's functions");
}

std::string list_of_materials(const Materials& materials) {
  std::size_t column = 0;
  for (const KnownMaterial& known : materials.list()) column = std::max(column, known.key.size());
  std::string text =
      "Used as in plate { material = \"duran50\" }; for your own: help \"material\"\n";
  for (const KnownMaterial& known : materials.list())
    text += fmt::format("\n  {:<{}}  {}", known.key, column,
                        hanging(describe(known.material), column + 4, reference_width));
  return text;
}

std::string help_on_word(lua_State* L, std::string_view word) {
  if (word == "materials") return list_of_materials(session_of(L).materials());
  try {
    return reference_of(word);
  } catch (const Error&) {
    const std::string found = search_reference(word);
    if (found.empty()) throw;
    return fmt::format("'{}' is found in\n{}", word.substr(0, 40), found);
  }
}

}  // namespace

std::string help_on(lua_State* L) {
  if (lua_isnoneornil(L, 1)) return tour();
  if (lua_iscfunction(L, 1)) return help_on_function(lua_tocfunction(L, 1));
  if (lua_type(L, 1) == LUA_TSTRING) return help_on_word(L, lua_tostring(L, 1));
  if (const TypeDoc* type = type_at(L, 1)) return reference_of(*type);
  throw Error(ErrorKind::refused, "help: nothing is known of " + description(L, 1),
              "help() gives a tour");
}

}  // namespace hackle
