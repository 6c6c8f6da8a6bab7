// SPDX-License-Identifier: MIT
#include "console/language/overrides.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "base/text.hpp"
#include "console/language/units_binding.hpp"
#include "console/lua/lua_state.hpp"
#include "console/schema/shell_value.hpp"
#include "console/session.hpp"
#include "scene/check_members.hpp"
#include "scene/material.hpp"
#include "scene/plate.hpp"

namespace hackle {
namespace {

// The keys set with a prefix, without it.
std::vector<std::pair<std::string, std::string>> set_with(std::string_view prefix,
                                                          const Session& session) {
  std::vector<std::pair<std::string, std::string>> found;
  for (const auto& [key, value] : session.settings.overrides)
    if (key.starts_with(prefix)) found.emplace_back(key.substr(prefix.size()), value);
  return found;
}

void push_shell_value(lua_State* L, const std::string& text) {
  if (text == "default") return lua_pushnil(L);
  if (text == "true" || text == "false") return lua_pushboolean(L, text == "true");
  if (const std::optional<double> number = shell_number(L, text)) return lua_pushnumber(L, *number);
  lua_pushlstring(L, text.data(), text.size());
}

// A strength replaces the other: the toughness of a bond follows from one of them.
void set_strength(Material& material, std::string_view name) {
  if (name == "G0") material.s0 = 0.0;
  if (name == "s0") material.G0 = 0.0;
}

constexpr auto scatter_keys =
    std::to_array<std::string_view>({"modulus", "deviation", "correlation", "seed"});

// Sets one member of a scatter; returns whether there is one of that name.
bool set_scatter(Scatter& scatter, std::string_view key, double value) {
  if (key == "modulus" || key == "deviation") {
    scatter.kind = key == "modulus" ? Scatter::Kind::weibull : Scatter::Kind::normal;
    scatter.spread = value;
  } else if (key == "correlation") {
    scatter.correlation = value;
  } else if (key == "seed") {
    scatter.seed = static_cast<std::int64_t>(value);
  } else {
    return false;
  }
  return true;
}

}  // namespace

std::optional<double> shell_number(lua_State* L, std::string_view text) {
  const int top = lua_gettop(L);
  const std::string chunk = "return " + shell_expression(text);
  if (luaL_loadbufferx(L, chunk.data(), chunk.size(), "=--set", "t") == LUA_OK) {
    lua_newtable(L);
    add_units(L);
    lua_getglobal(L, "math");
    lua_setfield(L, -2, "math");
    lua_setupvalue(L, -2, 1);
    if (lua_pcall(L, 0, 1, 0) == LUA_OK && lua_type(L, -1) == LUA_TNUMBER) {
      const double value = lua_tonumber(L, -1);
      lua_settop(L, top);
      if (std::isfinite(value)) return value;
      return std::nullopt;
    }
  }
  lua_settop(L, top);
  return std::nullopt;
}

void copy_table(lua_State* L, int index) {
  lua_newtable(L);
  for (lua_pushnil(L); lua_next(L, index) != 0;) {
    lua_pushvalue(L, -2);
    lua_insert(L, -2);
    lua_rawset(L, -4);
  }
  lua_replace(L, index);
}

void set_overrides(lua_State* L, int index, std::string_view prefix, const Session& session) {
  const auto given = set_with(prefix, session);
  if (given.empty() || lua_type(L, index) != LUA_TTABLE) return;
  copy_table(L, index);
  for (const auto& [key, value] : given) {
    push_shell_value(L, value);
    lua_setfield(L, index, key.c_str());
  }
}

void override_material(lua_State* L, const Session& session, Material& material,
                       Problems& problems) {
  for (const auto& set : set_with(material_prefix, session)) {
    const std::string &key = set.first, &value = set.second;  // bindings cannot be captured
    std::vector<std::string_view> names;
    bool known = false;
    for_each_member<Material>([&](const auto& member) {
      using Value = typename std::decay_t<decltype(member)>::Value;
      if constexpr (std::is_same_v<Value, double>) {
        names.push_back(member.name);
        if (member.name != key) return;
        known = true;
        const std::optional<double> number = shell_number(L, value);
        const auto why =
            number
                ? objection("--set material", key, *number, member.about.unit, member.about.range)
                : fmt::format("--set material.{}={}: not a finite number", key, value);
        if (why) return problems.add(*why);
        material.*member.pointer = *number;
        set_strength(material, key);
      }
    });
    if (!known)
      problems.add(fmt::format("--set material.{}={}: a material has no '{}'{}", key, value, key,
                               did_you_mean(key, names)),
                   "it has " + comma_list(names));
  }
}

void override_scatter(lua_State* L, const Session& session, Plate& plate, Problems& problems) {
  const auto given = set_with(scatter_prefix, session);
  if (given.empty()) return;
  Scatter scatter = plate.scatter.value_or(Scatter{});
  for (const auto& [key, value] : given) {
    const std::optional<double> number = shell_number(L, value);
    if (!number)
      problems.add(fmt::format("--set scatter.{}={}: not a finite number", key, value));
    else if (key == "seed" && !(std::abs(*number) < 1e15 && *number == std::floor(*number)))
      problems.add(fmt::format("--set scatter.seed={}: not a whole number", value));
    else if (!set_scatter(scatter, key, *number))
      problems.add(fmt::format("--set scatter.{}={}: a scatter has no '{}'{}", key, value, key,
                               did_you_mean(key, scatter_keys)),
                   "it has " + comma_list(scatter_keys));
  }
  if (scatter.spread == 0.0)
    return problems.add("--set scatter: the plate has no scatter of its own",
                        "set scatter.modulus or scatter.deviation too");
  check_members(scatter, "--set scatter", problems);
  plate.scatter = scatter;
}

}  // namespace hackle
