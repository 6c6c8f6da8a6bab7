// SPDX-License-Identifier: MIT
// Splits Lua text into tokens. The text may end anywhere, like a line being typed at the prompt.
#pragma once

#include <string_view>
#include <vector>

namespace hackle {

struct Token {
  enum class Kind { name, keyword, number, text, symbol };
  Kind kind = Kind::symbol;
  std::string_view word;  // as in the source

  bool is(std::string_view other) const { return word == other && kind != Kind::text; }
};

// Where the source ends: between or after words, in quotes, or in a comment or long-bracket text,
// where nothing can be completed.
enum class SourceEnd { code, quotes, silence };

// Holds views of the source.
struct Tokens {
  std::vector<Token> list;
  SourceEnd end = SourceEnd::code;
  std::string_view open_text;  // in quotes: from the last opening quote on
};

Tokens tokens_of(std::string_view source);

// Returns the reserved words of Lua 5.4, sorted.
const std::vector<std::string_view>& lua_keywords();

// Returns whether the text is a valid name of a variable.
bool is_lua_name(std::string_view text);

}  // namespace hackle
