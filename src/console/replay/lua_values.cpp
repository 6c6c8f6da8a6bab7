// SPDX-License-Identifier: MIT
#include "console/replay/lua_values.hpp"

#include <algorithm>
#include <vector>

namespace hackle {
namespace {

constexpr int max_depth = 32;
constexpr std::uint64_t max_count = 1U << 24U;

enum Tag : std::uint64_t { nil, no, yes, integer, real, text, table, function, object, deep };

// Returns whether it is plain: no function, no object, not nested too deeply.
class ValueWriter {
 public:
  ValueWriter(lua_State* L, const NameObject* name) : L_(L), name_(name) {}

  bool write(int index, JournalWriter& to, int depth = 0) const {
    switch (lua_type(L_, index)) {
      case LUA_TNIL:
        to.number(nil);
        return true;
      case LUA_TBOOLEAN:
        to.number(lua_toboolean(L_, index) != 0 ? yes : no);
        return true;
      case LUA_TNUMBER:
        write_number(index, to);
        return true;
      case LUA_TSTRING:
        write_text(index, to);
        return true;
      case LUA_TTABLE:
        return write_table(lua_absindex(L_, index), to, depth);
      case LUA_TFUNCTION:
        to.number(function);
        return false;
      default:
        break;
    }
    to.number(object);
    if (name_ != nullptr) to.text((*name_)(L_, index));
    return false;
  }

 private:
  void write_number(int index, JournalWriter& to) const {
    if (lua_isinteger(L_, index) != 0) {
      to.number(integer);
      to.number(static_cast<std::uint64_t>(lua_tointeger(L_, index)));
    } else {
      to.number(real);
      to.bits(lua_tonumber(L_, index));
    }
  }

  void write_text(int index, JournalWriter& to) const {
    std::size_t size = 0;
    const char* bytes = lua_tolstring(L_, index, &size);
    to.number(text);
    to.text({bytes, size});
  }

  // Lua's own order of keys differs from process to process.
  bool write_table(int index, JournalWriter& to, int depth) const {
    if (depth == max_depth || lua_checkstack(L_, 3) == 0) {
      to.number(deep);
      return false;
    }
    bool plain = true;
    std::vector<std::string> pairs;
    for (lua_pushnil(L_); lua_next(L_, index) != 0; lua_pop(L_, 1)) {
      JournalWriter pair;
      plain = write(-2, pair, depth + 1) && plain;
      plain = write(-1, pair, depth + 1) && plain;
      pairs.push_back(pair.bytes());
    }
    std::ranges::sort(pairs);
    to.number(table);
    to.number(pairs.size());
    for (const std::string& pair : pairs) to.raw(pair);
    return plain;
  }

  lua_State* L_;
  const NameObject* name_;
};

void push_value(lua_State* L, JournalReader& from, int depth) {
  if (depth > max_depth) throw JournalMismatch("its values are nested too deeply");
  luaL_checkstack(L, 3, nullptr);
  switch (from.number()) {
    case nil:
      return lua_pushnil(L);
    case no:
      return lua_pushboolean(L, 0);
    case yes:
      return lua_pushboolean(L, 1);
    case integer:
      return lua_pushinteger(L, static_cast<lua_Integer>(from.number()));
    case real:
      return lua_pushnumber(L, from.bits());
    case text:
      return push_text(L, from.text());
    case table:
      break;
    default:
      throw JournalMismatch("a value of unknown kind");
  }
  lua_newtable(L);
  for (std::uint64_t count = from.number(); count > 0; --count) {
    push_value(L, from, depth + 1);
    if (lua_isnil(L, -1)) throw JournalMismatch("a key is missing");
    push_value(L, from, depth + 1);
    lua_rawset(L, -3);
  }
}

}  // namespace

std::string texts_of(lua_State* L, int first, int last, const NameObject& name) {
  JournalWriter text;
  const ValueWriter writer(L, &name);
  for (int index = first; index <= last; ++index) writer.write(index, text);
  return text.bytes();
}

bool write_values(lua_State* L, int first, int last, JournalWriter& journal) {
  JournalWriter values;
  const ValueWriter writer(L, nullptr);
  for (int index = first; index <= last; ++index)
    if (!writer.write(index, values)) return false;
  journal.number(static_cast<std::uint64_t>(std::max(last - first + 1, 0)));
  journal.raw(values.bytes());
  return true;
}

int push_values(lua_State* L, JournalReader& journal) {
  const std::uint64_t count = journal.number();
  if (count > max_count || lua_checkstack(L, static_cast<int>(count) + 3) == 0)
    throw JournalMismatch("too many values");
  for (std::uint64_t k = 0; k < count; ++k) push_value(L, journal, 0);
  return static_cast<int>(count);
}

}  // namespace hackle
