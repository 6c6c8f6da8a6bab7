// SPDX-License-Identifier: MIT
// What a path of names leads to, found without running anything of the script.
#pragma once

#include "console/prompt/cursor.hpp"
#include "console/schema/schema.hpp"

namespace hackle {

// At most one of the three is there; all are empty when nothing is known.
struct RawValue {
  int table = 0;                    // its place on the stack
  const TypeDoc* type = nullptr;    // of an object
  const Property* field = nullptr;  // a table that an object would make

  bool known() const { return table != 0 || type != nullptr || field != nullptr; }
};

// [-0, +some] Tables are read raw; what __index holds counts when it is a table. A text has the
// functions of `string`.
RawValue raw_value(lua_State* L, const NamePath& path);

// The doc of one of our functions that the path names; of a method of an object that is not known
// yet, as in plate{...}:crack, the first of that name. Null when it is none.
const FunctionDoc* doc_of(lua_State* L, const NamePath& path);

// The type of an object of ours on the stack, or null.
const TypeDoc* type_at(lua_State* L, int index);

// The function of ours that a global C function is, or null.
const FunctionDoc* doc_of_global(lua_State* L, int index);

// The names among the keys of the table, and of the tables behind its __index.
struct Key {
  std::string_view name;  // lives as long as its table
  bool is_function = false;
};
std::vector<Key> keys_of(lua_State* L, int table);

}  // namespace hackle
