// SPDX-License-Identifier: MIT
#include "console/schema/given_value.hpp"

#include <utility>

#include <fmt/format.h>

#include "console/lua/description.hpp"

namespace hackle {

std::string GivenValue::name() const {
  return fmt::format("{}: {}", doc.name, option.name);
}

bool GivenValue::is_list() const {
  if (lua_type(L, index) != LUA_TTABLE) return wrong_type().has_value();
  const lua_Unsigned count = lua_rawlen(L, index);
  if (option.range.holds(static_cast<double>(count)) && entries(L, index) == count) return true;
  return wrong(fmt::format("{} is not {}", name(), expectation(option))).has_value();
}

std::any GivenValue::wrong(std::string what, std::string remedy) const {
  problems.add(std::move(what), std::move(remedy));
  return {};
}

std::any GivenValue::wrong_type() const {
  return wrong(
      fmt::format("{} is {}, expected {}", name(), description(L, index), expectation(option)));
}

std::size_t entries(lua_State* L, int index) {
  std::size_t count = 0;
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) ++count;
  return count;
}

}  // namespace hackle
