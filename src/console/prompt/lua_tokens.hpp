// SPDX-License-Identifier: MIT
// The words of Lua text that may end anywhere, as a line at the prompt does while it is typed.
#pragma once

#include <string_view>
#include <vector>

namespace hackle {

struct Token {
  enum class Kind { name, keyword, number, text, symbol };
  Kind kind = Kind::symbol;
  std::string_view word;  // as it stands in the source

  bool is(std::string_view other) const { return word == other && kind != Kind::text; }
};

// Where the source ends: between or behind words, in quotes, or where there is nothing to say: in
// a comment or a text of long brackets.
enum class SourceEnd { code, quotes, silence };

// Views of the source.
struct Tokens {
  std::vector<Token> list;
  SourceEnd end = SourceEnd::code;
  std::string_view open_text;  // in quotes: from the quote on that was opened last
};

Tokens tokens_of(std::string_view source);

// The reserved words of Lua 5.4, in order.
const std::vector<std::string_view>& lua_keywords();

// Whether the text could name a variable.
bool is_lua_name(std::string_view text);

}  // namespace hackle
