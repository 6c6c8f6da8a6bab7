// SPDX-License-Identifier: MIT
#include "console/lua/module_binding.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/files.hpp"
#include "console/lua/guard.hpp"
#include "console/schema/object_type.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

std::string replaced(std::string_view text, std::string_view what, std::string_view by) {
  std::string result;
  for (std::size_t at = text.find(what); !what.empty() && at != std::string_view::npos;
       at = text.find(what)) {
    result.append(text.substr(0, at)).append(by);
    text.remove_prefix(at + what.size());
  }
  return result.append(text);
}

std::string checked_text(lua_State* L, int index) {
  std::size_t size = 0;
  const char* text = luaL_checklstring(L, index, &size);
  if (std::string_view(text, size).find('\0') != std::string_view::npos)
    throw Error(ErrorKind::refused, "require: a name holds a zero byte");
  return {text, size};
}

// Returns the first existing file on a path of templates such as "lib/?.lua;lib/?/init.lua". Adds
// the files it tried to `tried`. Throws Error (refused) for a file that a script may not read.
std::optional<std::string> find_module(const Session& session, const std::string& name,
                                       std::string_view path, std::string& tried) {
  const Sandbox sandbox = session.sandbox();
  while (!path.empty()) {
    const std::string file = replaced(std::string(path.substr(0, path.find(';'))), "?", name);
    path.remove_prefix(std::min(path.find(';'), path.size() - 1) + 1);
    std::error_code ignored;
    if (!file.empty()) sandbox.check_input("require", file);
    if (std::filesystem::is_regular_file(file, ignored)) return file;
    tried += "\n\tno file '" + file + "'";
  }
  return std::nullopt;
}

int search_path(lua_State* L) {
  const std::string separator = lua_isnoneornil(L, 3) ? "." : checked_text(L, 3);
  const std::string slash = lua_isnoneornil(L, 4) ? LUA_DIRSEP : checked_text(L, 4);
  std::string tried;
  const auto file = find_module(session_of(L), replaced(checked_text(L, 1), separator, slash),
                                checked_text(L, 2), tried);
  if (!file) luaL_pushfail(L);
  push_text(L, file.value_or(tried));
  return file ? 1 : 2;
}

// A searcher: returns the loader and the file name, or the files it has tried.
int search_module(lua_State* L) {
  lua_getfield(L, lua_upvalueindex(1), "path");
  std::string tried;
  const auto file = find_module(session_of(L), replaced(checked_text(L, 1), ".", LUA_DIRSEP),
                                checked_text(L, 2), tried);
  push_text(L, file.value_or(tried));
  if (!file) return 1;
  if (luaL_loadfilex(L, file->c_str(), "t") != LUA_OK)
    return luaL_error(L, "error loading module '%s':\n\t%s", lua_tostring(L, 1),
                      lua_tostring(L, -1));
  lua_insert(L, -2);
  return 2;
}

}  // namespace

void open_modules(lua_State* L) {
  lua_getglobal(L, "package");
  lua_getfield(L, -1, "searchers");
  for (lua_Integer k = luaL_len(L, -1); k > 1; --k) {
    lua_pushnil(L);
    lua_rawseti(L, -2, k);
  }
  lua_pushvalue(L, -2);
  lua_pushcclosure(L, guarded<search_module>, 1);
  lua_rawseti(L, -2, 2);
  lua_pop(L, 1);
  lua_pushcfunction(L, guarded<search_path>);
  lua_setfield(L, -2, "searchpath");
  lua_pop(L, 1);
  look_for_modules_in(L, "");
}

void look_for_modules_in(lua_State* L, const std::filesystem::path& folder) {
  std::string path = (folder / "?.lua").string() + ";" + (folder / "?/init.lua").string();
  if (const auto scripts = find_data_file("scripts"))
    path += fmt::format(";{}", (*scripts / "?.lua").string());
  lua_getglobal(L, "package");
  const bool has_path = lua_getfield(L, -1, "path") == LUA_TSTRING;
  if (session_of(L).settings.trust && has_path) path += std::string(";") + lua_tostring(L, -1);
  lua_pop(L, 1);
  push_text(L, path);
  lua_setfield(L, -2, "path");
  lua_pop(L, 1);
}

}  // namespace hackle
