// SPDX-License-Identifier: MIT
#include "console/lua/value_text.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "console/lua/object_name.hpp"

namespace hackle {
namespace {

constexpr int deepest = 3;
constexpr std::size_t max_entries = 40;

std::string nested_text(lua_State* L, int index, int depth);

std::string shown_text(lua_State* L, int index) {
  std::size_t size = 0;
  const char* text = push_name(L, index, &size);
  std::string copy(text, size);
  lua_pop(L, 1);
  return copy;
}

// Returns the text as a literal of a script.
std::string as_literal(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out += {'\\', c};
    else if (c == '\n')
      out += "\\n";
    else if (byte < 32 || byte == 127)
      out += fmt::format("\\{}", byte);
    else
      out += c;
  }
  return out + "\"";
}

bool is_name(std::string_view text) {
  const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0 || c == '_'; };
  return !text.empty() && is_letter(static_cast<unsigned char>(text.front())) &&
         std::ranges::all_of(text,
                             [&](unsigned char c) { return is_letter(c) || std::isdigit(c) != 0; });
}

std::string key_text(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TSTRING) return fmt::format("[{}]", shown_text(L, index));
  const std::string text = shown_text(L, index);
  return is_name(text) ? text : fmt::format("[{}]", as_literal(text));
}

// Returns whether the value has its own text.
bool has_text(lua_State* L, int index) {
  for (const char* field : {"__tostring", "__name"}) {
    if (luaL_getmetafield(L, index, field) == LUA_TNIL) continue;
    lua_pop(L, 1);
    return true;
  }
  return false;
}

struct Others {
  std::vector<std::pair<std::string, std::string>> entries;  // by key
  std::size_t count = 0;
};

// Returns the entries outside the list 1..listed; if there are very many, the first ones found.
Others others(lua_State* L, int index, lua_Integer listed, int depth) {
  constexpr std::size_t max_sorted = 1000;
  Others found;
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
    const int key = lua_gettop(L) - 1;
    if (lua_isinteger(L, key) && lua_tointeger(L, key) >= 1 && lua_tointeger(L, key) <= listed)
      continue;
    if (++found.count > max_sorted) continue;
    std::string name = key_text(L, key);
    found.entries.emplace_back(std::move(name), nested_text(L, key + 1, depth + 1));
  }
  std::ranges::sort(found.entries);
  return found;
}

std::string table_text(lua_State* L, int index, int depth) {
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, index));
  std::vector<std::string> parts;
  for (lua_Integer k = 1; k <= count && parts.size() < max_entries; ++k) {
    lua_rawgeti(L, index, k);
    parts.push_back(nested_text(L, lua_gettop(L), depth + 1));
    lua_pop(L, 1);
  }
  const Others named = others(L, index, count, depth);
  for (const auto& [key, value] : named.entries)
    if (parts.size() < max_entries) parts.push_back(fmt::format("{} = {}", key, value));
  const std::size_t all = static_cast<std::size_t>(count) + named.count;
  if (all > parts.size()) parts.push_back(fmt::format("... {} more", all - parts.size()));
  std::string text;
  for (const std::string& part : parts) {
    if (!text.empty()) text += ", ";
    text += part;
  }
  return "{" + text + "}";
}

std::string nested_text(lua_State* L, int index, int depth) {
  luaL_checkstack(L, 6, "a table too deep to show");
  if (lua_type(L, index) == LUA_TSTRING) return as_literal(shown_text(L, index));
  if (lua_type(L, index) != LUA_TTABLE || has_text(L, index)) return shown_text(L, index);
  return depth < deepest ? table_text(L, index, depth) : "{...}";
}

}  // namespace

std::string value_text(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TSTRING) return shown_text(L, index);
  return nested_text(L, lua_absindex(L, index), 0);
}

}  // namespace hackle
