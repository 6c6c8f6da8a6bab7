// SPDX-License-Identifier: MIT
#include "console/lua/table_sort.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "console/lua/guard.hpp"

namespace hackle {
namespace {

// Stack indices.
constexpr int sorted_table = 1, order_function = 2, first_list = 3, second_list = 4;

constexpr lua_Integer between_looks = 1 << 14;

struct Runs {
  lua_Integer begin, middle, end;  // two sorted runs: [begin, middle) and [middle, end)
};

// Returns whether element b of the list comes before element a.
bool is_less(lua_State* L, int list, lua_Integer b, lua_Integer a) {
  const bool by_function = !lua_isnil(L, order_function);
  if (by_function) lua_pushvalue(L, order_function);
  lua_rawgeti(L, list, b);
  lua_rawgeti(L, list, a);
  bool less = false;
  if (by_function) {
    lua_call(L, 2, 1);
    less = lua_toboolean(L, -1) != 0;
    lua_pop(L, 1);
  } else {
    less = lua_compare(L, -2, -1, LUA_OPLT) != 0;
    lua_pop(L, 2);
  }
  return less;
}

void merge(lua_State* L, int from, int to, const Runs& range) {
  lua_Integer left = range.begin, right = range.middle;
  for (lua_Integer k = range.begin; k < range.end; ++k) {
    const bool take_right =
        left == range.middle || (right < range.end && is_less(L, from, right, left));
    lua_rawgeti(L, from, take_right ? right++ : left++);
    lua_rawseti(L, to, k);
    if (k % between_looks == 0 && interrupted()) throw Error(ErrorKind::interrupted, "interrupted");
  }
}

// Merges runs of 1, 2, 4, ... elements from one list into the other and back.
int merge_all(lua_State* L, lua_Integer count) {
  int from = first_list, to = second_list;
  for (lua_Integer width = 1; width < count; width *= 2) {
    for (lua_Integer begin = 1; begin <= count; begin += 2 * width)
      merge(L, from, to,
            {begin, std::min(begin + width, count + 1), std::min(begin + 2 * width, count + 1)});
    std::swap(from, to);
  }
  return from;
}

int sort_table(lua_State* L) {
  if (!lua_istable(L, sorted_table) && luaL_getmetafield(L, sorted_table, "__index") == LUA_TNIL)
    luaL_checktype(L, sorted_table, LUA_TTABLE);
  const lua_Integer count = luaL_len(L, sorted_table);
  if (count < 2) return 0;
  luaL_argcheck(L, count < std::numeric_limits<int>::max(), sorted_table, "array too big");
  if (!lua_isnoneornil(L, order_function)) luaL_checktype(L, order_function, LUA_TFUNCTION);
  lua_settop(L, order_function);
  lua_createtable(L, static_cast<int>(count), 0);
  lua_createtable(L, static_cast<int>(count), 0);
  for (lua_Integer k = 1; k <= count; ++k) {
    lua_geti(L, sorted_table, k);
    lua_rawseti(L, first_list, k);
  }
  const int list = merge_all(L, count);
  for (lua_Integer k = 1; k <= count; ++k) {
    lua_rawgeti(L, list, k);
    lua_seti(L, sorted_table, k);
  }
  return 0;
}

}  // namespace

void open_table_sort(lua_State* L) {
  lua_getglobal(L, "table");
  lua_pushcfunction(L, guarded<sort_table>);
  lua_setfield(L, -2, "sort");
  lua_pop(L, 1);
}

}  // namespace hackle
