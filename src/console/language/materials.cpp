// SPDX-License-Identifier: MIT
#include "console/language/materials.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/files.hpp"
#include "base/text.hpp"
#include "console/language/units_binding.hpp"
#include "console/lua/error_object.hpp"

namespace hackle {
namespace {

std::string text_field(lua_State* L, const char* name) {
  lua_getfield(L, -1, name);
  std::string text = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
  lua_pop(L, 1);
  return text;
}

double number_field(lua_State* L, const char* name) {
  lua_getfield(L, -1, name);
  const double value = lua_tonumber(L, -1);
  lua_pop(L, 1);
  return value;
}

// Reads a material from the table on top of the stack.
KnownMaterial read_material(lua_State* L, const std::string& key) {
  if (lua_type(L, -1) != LUA_TTABLE)
    throw Error(ErrorKind::files, fmt::format("material '{}' is not a table", key));
  KnownMaterial known{key, {}, text_field(L, "source")};
  known.material.name = text_field(L, "title");
  known.material.E = number_field(L, "E");
  known.material.rho = number_field(L, "rho");
  known.material.nu = number_field(L, "nu");
  known.material.G0 = number_field(L, "G0");
  known.material.alpha = number_field(L, "alpha");
  known.material.alphaT = number_field(L, "alphaT");
  known.material.fringe = number_field(L, "fringe");
  known.material.s0 = number_field(L, "s0");
  Problems problems;
  check(known.material, problems);
  if (known.material.name.empty()) problems.add(fmt::format("material '{}' has no title", key));
  problems.throw_if_any(ErrorKind::files);
  return known;
}

void run_library(lua_State* L, const std::filesystem::path& file) {
  const std::string text = read_text(file);
  const std::string chunk = fmt::format("@{}", file.string());
  if (luaL_loadbufferx(L, text.data(), text.size(), chunk.c_str(), "t") != LUA_OK)
    throw take_error(L);
  protected_call(L, 0, 1);
  if (lua_type(L, -1) != LUA_TTABLE)
    throw Error(ErrorKind::files, fmt::format("'{}' returns no table", file.string()));
}

}  // namespace

Materials::Materials(const std::filesystem::path& file) {
  // A separate state: a script cannot affect the library.
  const LuaState state;
  open_errors(state);
  open_units(state);
  run_library(state, file);
  for (lua_pushnil(state); lua_next(state, -2) != 0; lua_pop(state, 1))
    if (lua_type(state, -2) == LUA_TSTRING)
      list_.push_back(read_material(state, lua_tostring(state, -2)));
  std::ranges::sort(list_, {}, &KnownMaterial::key);
}

const KnownMaterial& Materials::find(std::string_view key) const {
  const auto found = std::ranges::find(list_, key, &KnownMaterial::key);
  if (found != list_.end()) return *found;
  std::vector<std::string_view> keys;
  for (const KnownMaterial& known : list_) keys.push_back(known.key);
  throw Error(
      ErrorKind::refused,
      fmt::format("there is no material '{}'{}", key.substr(0, 40), did_you_mean(key, keys)),
      fmt::format("known are {}; others: material {{ E = ..., rho = ..., G0 = ... }}",
                  comma_list(keys)));
}

}  // namespace hackle
