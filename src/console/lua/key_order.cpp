// SPDX-License-Identifier: MIT
#include "console/lua/key_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <tuple>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "console/lua/guard.hpp"

namespace hackle {
namespace {

enum class Rank : std::uint8_t { index, number, text, truth, of_program, made };

// A key in comparable form. Its text belongs to Lua.
struct TableKey {
  Rank rank = Rank::number;
  lua_Integer whole = 0;  // a number rounded down; for others their rank
  double rest = 0.0;      // fractional part of a number
  std::string_view text;
  lua_Integer place = 0;  // in the list of keys

  friend bool operator<(const TableKey& one, const TableKey& other) {
    return std::tie(one.rank, one.whole, one.rest, one.text) <
           std::tie(other.rank, other.whole, other.rest, other.text);
  }
};

// Puts integers and floats in one order. A float that is no Lua integer has a fraction, or lies
// beyond all integers.
TableKey key_of_number(lua_State* L, int index) {
  if (lua_isinteger(L, index)) {
    const lua_Integer whole = lua_tointeger(L, index);
    return {whole >= 1 ? Rank::index : Rank::number, whole};
  }
  const double value = lua_tonumber(L, index);
  if (value >= 0x1p63) return {Rank::number, std::numeric_limits<lua_Integer>::max(), value};
  if (value < -0x1p63) return {Rank::number, std::numeric_limits<lua_Integer>::min(), value};
  const double whole = std::floor(value);
  return {Rank::number, static_cast<lua_Integer>(whole), value - whole};
}

// Values without memory of their own have no creation number: C functions without upvalues, and
// light userdata. Their distances are the same in every process of one program.
TableKey key_of_object(lua_State* L, int index) {
  const bool of_program = lua_islightuserdata(L, index) ||
                          (lua_iscfunction(L, index) && lua_getupvalue(L, index, 1) == nullptr);
  if (lua_iscfunction(L, index) && !of_program) lua_pop(L, 1);
  if (of_program) {
    const auto address = reinterpret_cast<std::intptr_t>(lua_topointer(L, index));
    return {Rank::of_program, static_cast<lua_Integer>(address)};
  }
  return {Rank::made, static_cast<lua_Integer>(birth_of(L, index))};
}

TableKey table_key_at(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TNUMBER:
      return key_of_number(L, index);
    case LUA_TSTRING: {
      std::size_t size = 0;
      const char* text = lua_tolstring(L, index, &size);
      return {Rank::text, 0, 0.0, {text, size}};
    }
    case LUA_TBOOLEAN:
      return {Rank::truth, lua_toboolean(L, index)};
    default:
      return key_of_object(L, index);
  }
}

// Checks for interrupts now and then: large tables take a while.
class Patience {
 public:
  void wait() {
    constexpr int between_looks = 1 << 14;
    if (++count_ % between_looks == 0 && interrupted())
      throw Error(ErrorKind::interrupted, "interrupted");
  }

 private:
  int count_ = 0;
};

// Returns the largest n with entries 1..n.
lua_Integer run_length(lua_State* L, int table) {
  lua_Integer n = 0;
  Patience patience;
  while (lua_rawgeti(L, table, n + 1) != LUA_TNIL) {
    lua_pop(L, 1);
    ++n;
    patience.wait();
  }
  lua_pop(L, 1);
  return n;
}

// [-0, +1] Pushes an unsorted list of the keys beyond 1..n. Returns their number.
lua_Integer push_other_keys(lua_State* L, int table, lua_Integer n) {
  lua_newtable(L);
  lua_Integer count = 0;
  Patience patience;
  for (lua_pushnil(L); lua_next(L, table) != 0;) {
    patience.wait();
    lua_pop(L, 1);
    if (lua_isinteger(L, -1) && lua_tointeger(L, -1) >= 1 && lua_tointeger(L, -1) <= n) continue;
    lua_pushvalue(L, -1);
    lua_rawseti(L, -3, ++count);
  }
  return count;
}

// [-1, +1] Sorts the list of `count` keys on top. It uses Lua's memory, which is counted.
void sort_keys(lua_State* L, lua_Integer count) {
  const int list = lua_gettop(L);
  const auto size = static_cast<std::size_t>(count);
  TableKey* keys = static_cast<TableKey*>(lua_newuserdatauv(L, size * sizeof(TableKey), 0));
  for (lua_Integer place = 1; place <= count; ++place) {
    lua_rawgeti(L, list, place);
    new (keys + (place - 1)) TableKey(table_key_at(L, lua_gettop(L)));
    keys[place - 1].place = place;
    lua_pop(L, 1);
  }
  if (!std::is_sorted(keys, keys + size)) {
    Patience patience;
    std::sort(keys, keys + size, [&](const TableKey& one, const TableKey& other) {
      patience.wait();
      return one < other;
    });
    lua_createtable(L, static_cast<int>(std::min<lua_Integer>(count, 1 << 26)), 0);
    for (std::size_t k = 0; k < size; ++k) {
      lua_rawgeti(L, list, keys[k].place);
      lua_rawseti(L, -2, static_cast<lua_Integer>(k) + 1);
    }
    lua_replace(L, list);
  }
  lua_settop(L, list);
}

// A traversal is itself a table: {n, list of the other keys, number of keys visited}.
enum WalkEntry : lua_Integer { entry_run = 1, entry_keys, entry_visited };

// [-0, +1] Starts a traversal of the table at the absolute index.
void push_walk(lua_State* L, int table) {
  lua_createtable(L, 3, 0);
  const lua_Integer n = run_length(L, table);
  lua_pushinteger(L, n);
  lua_rawseti(L, -2, entry_run);
  sort_keys(L, push_other_keys(L, table, n));
  lua_rawseti(L, -2, entry_keys);
  lua_pushinteger(L, 0);
  lua_rawseti(L, -2, entry_visited);
}

lua_Integer entry_of(lua_State* L, int walk, WalkEntry entry) {
  lua_rawgeti(L, walk, entry);
  const lua_Integer value = lua_tointeger(L, -1);
  lua_pop(L, 1);
  return value;
}

void set_visited(lua_State* L, int walk, lua_Integer visited) {
  lua_pushinteger(L, visited);
  lua_rawseti(L, walk, entry_visited);
}

// [-0, +1] Pushes key number `place`, nil beyond the last.
void push_key_of_walk(lua_State* L, int walk, lua_Integer n, lua_Integer place) {
  if (place <= n) return lua_pushinteger(L, place);
  lua_rawgeti(L, walk, entry_keys);
  lua_rawgeti(L, -1, place - n);
  lua_remove(L, -2);
}

// [-0, +2 or +1] Pushes the next existing key and its value; or nil.
int advance_walk(lua_State* L, int table, int walk) {
  const lua_Integer n = entry_of(L, walk, entry_run);
  for (lua_Integer place = entry_of(L, walk, entry_visited) + 1;; ++place) {
    push_key_of_walk(L, walk, n, place);
    if (lua_isnil(L, -1)) return 1;
    lua_pushvalue(L, -1);
    if (lua_rawget(L, table) != LUA_TNIL) {
      set_visited(L, walk, place);
      return 2;
    }
    lua_pop(L, 2);
  }
}

// The iterator returned by pairs; with key nil it starts again.
int visit_next(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 2);
  lua_pushvalue(L, lua_upvalueindex(1));
  if (lua_isnil(L, 2)) set_visited(L, 3, 0);
  return advance_walk(L, 1, 3);
}

int ordered_pairs(lua_State* L) {
  luaL_checkany(L, 1);
  if (luaL_getmetafield(L, 1, "__pairs") != LUA_TNIL) {
    lua_pushvalue(L, 1);
    lua_callk(L, 1, 3, 0, [](lua_State*, int, lua_KContext) { return 3; });
    return 3;
  }
  luaL_checktype(L, 1, LUA_TTABLE);
  push_walk(L, 1);
  lua_pushcclosure(L, visit_next, 1);
  lua_pushvalue(L, 1);
  lua_pushnil(L);
  return 3;
}

// of next: from table to traversal, while the table lives
constexpr int walks = lua_upvalueindex(1);

void keep_walk(lua_State* L, int table, int walk) {
  lua_pushvalue(L, table);
  lua_pushvalue(L, walk);
  lua_rawset(L, walks);
}

// Returns the position of a traversal after the key at the index, which may have been removed
// since; usually that is where it stands.
lua_Integer place_of(lua_State* L, int walk, int key) {
  const lua_Integer n = entry_of(L, walk, entry_run), visited = entry_of(L, walk, entry_visited);
  push_key_of_walk(L, walk, n, visited);
  const bool same = visited > 0 && lua_rawequal(L, -1, key) != 0;
  lua_pop(L, 1);
  if (same) return visited;
  const TableKey own = table_key_at(L, key);
  if (own.rank == Rank::index && own.whole <= n) return own.whole;
  Patience patience;
  for (lua_Integer place = n + 1;; ++place) {
    push_key_of_walk(L, walk, n, place);
    const bool beyond = lua_isnil(L, -1) || own < table_key_at(L, lua_gettop(L));
    lua_pop(L, 1);
    if (beyond) return place - 1;
    patience.wait();
  }
}

// [-0, +2 or +1] Pushes the first key and its value, without sorting all keys.
int first_entry(lua_State* L, int table) {
  lua_pushinteger(L, 1);
  if (lua_rawgeti(L, table, 1) != LUA_TNIL) return 2;
  lua_settop(L, 2);
  lua_pushnil(L);  // smallest key so far
  Patience patience;
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
    patience.wait();
    if (!lua_isnil(L, 3) && !(table_key_at(L, 4) < table_key_at(L, 3))) continue;
    lua_pushvalue(L, 4);
    lua_replace(L, 3);
  }
  lua_settop(L, 3);
  if (lua_isnil(L, 3)) return 1;
  lua_pushvalue(L, 3);
  lua_rawget(L, table);
  return 2;
}

// Keeps the traversal of a table until it ends or starts again.
int ordered_next(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 2);
  if (lua_isnil(L, 2)) {
    lua_pushnil(L);
    keep_walk(L, 1, 3);
    lua_settop(L, 2);
    return first_entry(L, 1);
  }
  lua_pushvalue(L, 1);
  if (lua_rawget(L, walks) != LUA_TTABLE) {
    lua_pop(L, 1);
    push_walk(L, 1);
    keep_walk(L, 1, 3);
  }
  set_visited(L, 3, place_of(L, 3, 2));
  const int results = advance_walk(L, 1, 3);
  if (results == 1) keep_walk(L, 1, lua_gettop(L));
  return results;
}

}  // namespace

void open_key_order(lua_State* L) {
  lua_pushcfunction(L, guarded<ordered_pairs>);
  lua_setglobal(L, "pairs");
  lua_newtable(L);
  lua_newtable(L);
  lua_pushliteral(L, "k");
  lua_setfield(L, -2, "__mode");
  lua_setmetatable(L, -2);
  lua_pushcclosure(L, guarded<ordered_next>, 1);
  lua_setglobal(L, "next");
}

}  // namespace hackle
