// SPDX-License-Identifier: MIT
#include "console/lua/lua_tokens.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

namespace hackle {
namespace {

constexpr auto symbols =
    std::to_array<std::string_view>({"...", "..", "::", "==", "~=", "<=", ">=", "//", "<<", ">>"});

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

// Returns the number of = signs of a long bracket that opens the text, or -1.
int long_bracket(std::string_view text) {
  if (!text.starts_with('[')) return -1;
  const std::size_t second = std::min(text.find_first_not_of('=', 1), text.size());
  return second < text.size() && text[second] == '[' ? static_cast<int>(second) - 1 : -1;
}

class Reader {
 public:
  explicit Reader(std::string_view source) : rest_(source) {}

  Tokens read() {
    while (skip_blank() && found_.end == SourceEnd::code) read_token();
    return std::move(found_);
  }

 private:
  using Kind = Token::Kind;

  void take(Kind kind, std::size_t size) {
    found_.list.push_back({kind, rest_.substr(0, size)});
    rest_.remove_prefix(std::min(size, rest_.size()));
  }

  // Skips blanks and comments; returns false at the end.
  bool skip_blank() {
    for (;;) {
      while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
      if (!rest_.starts_with("--")) return !rest_.empty();
      rest_.remove_prefix(2);
      const int level = long_bracket(rest_);
      if (!skip_to(level < 0 ? "\n" : fmt::format("]{:=>{}}]", "", level))) return false;
    }
  }

  // Skips past the text; returns false, and sets silence, if it never comes.
  bool skip_to(const std::string& text) {
    const std::size_t at = rest_.find(text);
    if (at == std::string_view::npos) found_.end = SourceEnd::silence;
    rest_.remove_prefix(at == std::string_view::npos ? rest_.size() : at + text.size());
    return found_.end == SourceEnd::code;
  }

  void read_token() {
    const char c = rest_.front();
    const bool number = is_digit(c) || (c == '.' && rest_.size() > 1 && is_digit(rest_[1]));
    if (c == '"' || c == '\'') return read_quoted(c);
    if (number) return take(Kind::number, number_size());
    if (is_letter(c)) return read_word();
    if (const int level = long_bracket(rest_); level >= 0) return read_long(level);
    for (const std::string_view symbol : symbols)
      if (rest_.starts_with(symbol)) return take(Kind::symbol, symbol.size());
    take(Kind::symbol, 1);
  }

  void read_word() {
    std::size_t size = 1;
    while (size < rest_.size() && (is_letter(rest_[size]) || is_digit(rest_[size]))) ++size;
    const bool reserved = std::ranges::binary_search(lua_keywords(), rest_.substr(0, size));
    take(reserved ? Kind::keyword : Kind::name, size);
  }

  std::size_t number_size() const {
    std::size_t size = 1;
    for (; size < rest_.size(); ++size) {
      const char c = rest_[size], before = rest_[size - 1];
      const bool sign = (c == '+' || c == '-') && (before == 'e' || before == 'E');
      if (!is_digit(c) && !is_letter(c) && c != '.' && !sign) break;
    }
    return size;
  }

  void read_quoted(char quote) {
    for (std::size_t i = 1; i < rest_.size(); ++i) {
      if (rest_[i] == '\\')
        ++i;
      else if (rest_[i] == quote || rest_[i] == '\n')
        return take(Kind::text, i + 1);
    }
    found_.end = SourceEnd::quotes;
    found_.open_text = rest_;
  }

  void read_long(int level) {
    const std::string close = fmt::format("]{:=>{}}]", "", level);
    const std::size_t at = rest_.find(close);
    if (at == std::string_view::npos)
      found_.end = SourceEnd::silence;
    else
      take(Kind::text, at + close.size());
  }

  std::string_view rest_;
  Tokens found_;
};

}  // namespace

Tokens tokens_of(std::string_view source) {
  return Reader(source).read();
}

const std::vector<std::string_view>& lua_keywords() {
  static const std::vector<std::string_view> words{
      "and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
      "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
      "repeat",   "return", "then", "true", "until",  "while"};
  return words;
}

bool is_lua_name(std::string_view text) {
  return !text.empty() && is_letter(text.front()) &&
         std::ranges::all_of(text, [](char c) { return is_letter(c) || is_digit(c); }) &&
         !std::ranges::binary_search(lua_keywords(), text);
}

}  // namespace hackle
