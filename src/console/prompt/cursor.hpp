// SPDX-License-Identifier: MIT
// The context of the cursor in Lua text that is being typed: its word, its object, its call.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace hackle {

// "p:crack" or "s.energy" as written. It begins with a global or local name; if it begins
// otherwise, the first name is "".
struct NamePath {
  std::vector<std::string_view> names;
  bool is_method = false;  // a colon stands before the last name
};

// The call whose argument is being typed.
struct OpenCall {
  NamePath callee;
  bool in_braces = false;               // in its table of options
  bool at_name = false;                 // the name of an option may stand here
  std::string_view option;              // option whose value is being typed, or ""
  std::vector<std::string_view> given;  // names of the earlier options
  std::size_t nameless = 0;             // earlier values without a name
};

// Holds views of the text it was made from.
struct Cursor {
  bool silent = false;  // in a comment and the like: nothing can be completed
  bool in_quotes = false;
  char quote = '"';
  std::string_view word;  // typed part of a name, or since the quote
  char access = 0;        // '.' or ':' when the word belongs to an object
  NamePath object;        // that object
  std::optional<OpenCall> call;
  std::vector<std::string_view> locals;  // names declared by the text
};

Cursor cursor_at_end(std::string_view text);

}  // namespace hackle
