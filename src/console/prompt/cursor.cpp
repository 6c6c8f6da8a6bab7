// SPDX-License-Identifier: MIT
#include "console/prompt/cursor.hpp"

#include <algorithm>
#include <span>

#include "console/lua/lua_tokens.hpp"

namespace hackle {
namespace {

using Kind = Token::Kind;
using List = std::span<const Token>;

bool is_any(const Token& token, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) { return token.is(word); });
}

bool opens(const Token& token) {
  return is_any(token, {"(", "{", "[", "function", "do", "if", "repeat"});
}

bool closes(const Token& token) {
  return is_any(token, {")", "}", "]", "end", "until"});
}

// Returns the path that ends with the last token, which is a name.
NamePath path_at_end(List list) {
  NamePath path{{list.back().word}, false};
  list = list.first(list.size() - 1);
  while (!list.empty() && (list.back().is(".") || list.back().is(":"))) {
    if (path.names.size() == 1) path.is_method = list.back().is(":");
    list = list.first(list.size() - 1);
    const bool name = !list.empty() && list.back().kind == Kind::name;
    path.names.insert(path.names.begin(), name ? list.back().word : "");
    if (!name) return path;
    list = list.first(list.size() - 1);
  }
  return path;
}

// Returns the positions of the brackets and blocks that are open at the end.
std::vector<std::size_t> open_places(List list) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (opens(list[k])) places.push_back(k);
    if (closes(list[k]) && !places.empty()) places.pop_back();
  }
  return places;
}

// Splits the tokens after an open bracket at commas outside other brackets.
std::vector<List> entries(List list) {
  std::vector<List> parts;
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t k = 0; k < list.size(); ++k) {
    depth += int{opens(list[k])} - int{closes(list[k])};
    if (depth > 0 || !is_any(list[k], {",", ";"})) continue;
    parts.push_back(list.subspan(begin, k - begin));
    begin = k + 1;
  }
  parts.push_back(list.subspan(begin));
  return parts;
}

bool has_name(List entry) {
  return entry.size() > 1 && entry[0].kind == Kind::name && entry[1].is("=");
}

// Returns whether the tokens before a bracket or a quote make it the argument of a call.
bool is_callee(List before) {
  return !before.empty() && before.back().kind == Kind::name &&
         !(before.size() > 1 && before[before.size() - 2].is("function"));
}

std::optional<OpenCall> call_of_braces(List before, std::span<const std::size_t> places);

void read_entries(OpenCall& call, List inside) {
  std::vector<List> parts = entries(inside);
  const List last = parts.back();
  parts.pop_back();
  for (const List part : parts) {
    if (has_name(part)) call.given.push_back(part[0].word);
    call.nameless += has_name(part) ? 0 : 1;
  }
  call.at_name = last.empty();
  if (has_name(last) && last.size() == 2) call.option = last[0].word;
}

// Returns the call of the innermost open bracket.
std::optional<OpenCall> innermost_call(List list, std::span<const std::size_t> places) {
  if (places.empty()) return std::nullopt;
  const std::size_t at = places.back();
  const List before = list.first(at), inside = list.subspan(at + 1);
  if (list[at].is("(") && is_callee(before)) {
    OpenCall call{.callee = path_at_end(before)};
    read_entries(call, inside);
    call.at_name = false;
    return call;
  }
  if (!list[at].is("{")) return std::nullopt;
  auto call = call_of_braces(before, places.first(places.size() - 1));
  if (call && call->option.empty()) read_entries(*call, inside);
  return call;
}

// For braces after `before`: a table of options, or a list that is the value of an option.
std::optional<OpenCall> call_of_braces(List before, std::span<const std::size_t> places) {
  if (is_callee(before)) return OpenCall{.callee = path_at_end(before), .in_braces = true};
  auto outer = innermost_call(before, places);
  if (!outer) return std::nullopt;
  if (outer->in_braces) return outer->option.empty() ? std::nullopt : outer;
  return OpenCall{.callee = outer->callee, .in_braces = true};
}

// For f "text", a call without brackets.
std::optional<OpenCall> call_of_quotes(List list) {
  if (is_callee(list)) return OpenCall{.callee = path_at_end(list)};
  return innermost_call(list, open_places(list));
}

std::vector<std::string_view> declared(List list) {
  std::vector<std::string_view> names;
  for (std::size_t k = 1; k < list.size(); ++k)
    if (list[k].kind == Kind::name && is_any(list[k - 1], {"local", "for"}))
      names.push_back(list[k].word);
  return names;
}

// Moves the word being typed from the list to the cursor.
void read_word(Cursor& cursor, List& list, std::string_view text) {
  const bool typing = !list.empty() && list.back().word.end() == text.end();
  if (typing && list.back().kind == Kind::number) cursor.silent = true;
  if (typing && (list.back().kind == Kind::name || list.back().kind == Kind::keyword)) {
    cursor.word = list.back().word;
    list = list.first(list.size() - 1);
  }
  if (list.empty() || !is_any(list.back(), {".", ":"})) return;
  cursor.access = list.back().word.front();
  list = list.first(list.size() - 1);
  const bool name = !list.empty() && list.back().kind == Kind::name;
  cursor.object = name ? path_at_end(list) : NamePath{{""}, false};
}

}  // namespace

Cursor cursor_at_end(std::string_view text) {
  const Tokens tokens = tokens_of(text);
  List list = tokens.list;
  Cursor cursor;
  cursor.silent = tokens.end == SourceEnd::silence;
  cursor.in_quotes = tokens.end == SourceEnd::quotes;
  cursor.locals = declared(list);
  if (cursor.in_quotes) {
    cursor.word = tokens.open_text.substr(1);
    cursor.quote = tokens.open_text.front();
    cursor.call = call_of_quotes(list);
  } else {
    read_word(cursor, list, text);
    cursor.call = innermost_call(list, open_places(list));
  }
  return cursor;
}

}  // namespace hackle
