// SPDX-License-Identifier: MIT
// Finds the value of a path of names without running anything of the script.
#pragma once

#include "console/prompt/cursor.hpp"
#include "console/schema/schema.hpp"

namespace hackle {

// At most one of the three is set; none if nothing is known.
struct RawValue {
  int table = 0;                    // its stack index
  const TypeDoc* type = nullptr;    // of an object
  const Property* field = nullptr;  // a field whose value would be a table

  bool known() const { return table != 0 || type != nullptr || field != nullptr; }
};

// [-0, +some] Reads tables raw; __index counts if it is a table. A text has the functions of
// `string`.
RawValue raw_value(lua_State* L, const NamePath& path);

// Returns the doc of the bound function that the path names; for a method of an unknown object, as
// in plate{...}:crack, the first of that name. Null if there is none.
const FunctionDoc* doc_of(lua_State* L, const NamePath& path);

// Returns the type of a bound object on the stack, or null.
const TypeDoc* type_at(lua_State* L, int index);

// Returns the doc of the bound function that a global C function is, or null.
const FunctionDoc* doc_of_global(lua_State* L, int index);

// Names among the keys of a table, and of the tables behind its __index.
struct Key {
  std::string_view name;  // lives as long as its table
  bool is_function = false;
};
std::vector<Key> keys_of(lua_State* L, int table);

}  // namespace hackle
