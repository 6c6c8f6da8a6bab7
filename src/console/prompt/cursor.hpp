// SPDX-License-Identifier: MIT
// Where the cursor stands in Lua text that is being typed: in which word, of what, in which call.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace hackle {

// "p:crack" or "s.energy" as it is written. It begins with a global or local name, unless something
// else stands there: then the first name is "".
struct NamePath {
  std::vector<std::string_view> names;
  bool is_method = false;  // a colon stands before the last
};

// The call whose argument is being typed.
struct OpenCall {
  NamePath callee;
  bool in_braces = false;               // in its table of options
  bool at_name = false;                 // where the name of an option may stand
  std::string_view option;              // whose value is being typed, or ""
  std::vector<std::string_view> given;  // names of the options before
  std::size_t nameless = 0;             // values without a name before
};

// Views of the text it was made from.
struct Cursor {
  bool silent = false;  // in a comment and the like: nothing can be completed
  bool in_quotes = false;
  char quote = '"';
  std::string_view word;  // what is typed of a name, or since the quote
  char access = 0;        // '.' or ':' when the word belongs to an object
  NamePath object;        // which one
  std::optional<OpenCall> call;
  std::vector<std::string_view> locals;  // names that the text declares
};

Cursor cursor_at_end(std::string_view text);

}  // namespace hackle
