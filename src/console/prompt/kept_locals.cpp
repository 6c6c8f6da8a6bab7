// SPDX-License-Identifier: MIT
#include "console/prompt/kept_locals.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "console/lua/lua_tokens.hpp"

namespace hackle {
namespace {

constexpr auto openers = std::to_array<std::string_view>({"do", "function", "if", "repeat"});
constexpr auto closers = std::to_array<std::string_view>({"end", "until"});

bool is_one_of(const Token& token, const auto& words) {
  return token.kind == Token::Kind::keyword && std::ranges::find(words, token.word) != words.end();
}

// A part of the text that is replaced.
struct Edit {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string_view replacement;
};

// Calls visit(k) for every token outside all blocks.
void for_each_outside(const std::vector<Token>& tokens, const auto& visit) {
  int depth = 0;
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    if (is_one_of(tokens[k], openers)) ++depth;
    if (is_one_of(tokens[k], closers)) --depth;
    if (depth == 0) visit(k);
  }
}

class Locals {
 public:
  explicit Locals(std::string_view text) : text_(text), tokens_(tokens_of(text).list) {}

  std::vector<Edit> edits() const {
    std::vector<Edit> all;
    for_each_outside(tokens_, [&](std::size_t k) {
      if (!tokens_[k].is("local")) return;
      if (const auto edits = edits_of(k)) all.insert(all.end(), edits->begin(), edits->end());
    });
    return all;
  }

 private:
  bool has(std::size_t k, std::string_view word) const {
    return k < tokens_.size() && tokens_[k].is(word);
  }
  bool is_name(std::size_t k) const {
    return k < tokens_.size() && tokens_[k].kind == Token::Kind::name;
  }
  std::size_t place(std::size_t k) const {
    return static_cast<std::size_t>(tokens_[k].word.data() - text_.data());
  }
  std::size_t end(std::size_t k) const { return place(k) + tokens_[k].word.size(); }

  // Returns nothing for a statement that is not understood or must stay.
  std::optional<std::vector<Edit>> edits_of(std::size_t local) const {
    const bool blank = text_.substr(end(local)).starts_with(' ');
    std::vector<Edit> edits{{place(local), end(local) + (blank ? 1 : 0), ""}};
    if (has(local + 1, "function")) return edits;
    std::size_t k = local;
    do {
      if (!is_name(++k)) return std::nullopt;
      if (has(k + 1, "<")) {
        if (!has(k + 2, "const") || !has(k + 3, ">")) return std::nullopt;
        edits.push_back({place(k + 1), end(k + 3), ""});
        k += 3;
      }
    } while (has(++k, ","));
    if (!has(k, "=")) edits.push_back({end(k - 1), end(k - 1), " = nil"});
    return edits;
  }

  std::string_view text_;
  std::vector<Token> tokens_;
};

constexpr auto scoped = std::to_array<std::string_view>({"local", "return", "goto"});

}  // namespace

bool needs_a_scope(std::string_view text) {
  const std::vector<Token> tokens = tokens_of(text).list;
  bool found = false;
  for_each_outside(tokens, [&](std::size_t k) { found = found || is_one_of(tokens[k], scoped); });
  return found;
}

std::string with_locals_kept(std::string_view text) {
  std::string kept;
  std::size_t from = 0;
  for (const Edit& edit : Locals(text).edits()) {
    kept += text.substr(from, edit.begin - from);
    kept += edit.replacement;
    from = edit.end;
  }
  return kept.append(text.substr(from));
}

}  // namespace hackle
