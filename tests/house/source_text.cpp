// SPDX-License-Identifier: MIT
#include "house/source_text.hpp"

#include <algorithm>
#include <optional>
#include <regex>

namespace hackle {
namespace {

constexpr auto npos = std::string_view::npos;

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// The place after a comment, text, character or directive that begins at `at`; `at` itself if none
// does.
std::size_t end_of_opaque(std::string_view source, std::size_t at) {
  const auto after = [&](std::string_view end, std::size_t from) {
    const std::size_t found = source.find(end, from);
    return found == npos ? source.size() : found + end.size();
  };
  const std::string_view rest = source.substr(at);
  const char before = at == 0 ? '\n' : source[at - 1];
  if (rest.starts_with("//")) return after("\n", at);
  if (rest.starts_with("/*")) return after("*/", at + 2);
  if (rest.starts_with("R\"") && !is_of_word(before)) {
    const std::size_t open = source.find('(', at);
    return after(")" + std::string(source.substr(at + 2, open - at - 2)) + "\"", open);
  }
  std::size_t end = at;
  if (rest.starts_with("#") && before == '\n') {
    do end = after("\n", end);
    while (end >= 2 && source[end - 2] == '\\' && end < source.size());
  } else if (rest.starts_with("\"") || (rest.starts_with("'") && !is_of_word(before))) {
    for (++end; end < source.size() && source[end] != rest[0]; ++end)
      if (source[end] == '\\') ++end;
    end = std::min(end + 1, source.size());
  }
  return end;
}

// Without comments, texts and directives; blanks of any kind become one.
std::string bare(std::string_view source) {
  std::string text;
  for (std::size_t at = 0; at < source.size();) {
    const std::size_t end = end_of_opaque(source, at);
    const bool blank = end > at || std::isspace(static_cast<unsigned char>(source[at])) != 0;
    if (!blank) text += source[at];
    if (blank && !text.empty() && text.back() != ' ') text += ' ';
    at = std::max(end, at + 1);
  }
  return text;
}

// The place of the first of some characters outside <> and ().
std::size_t find_outside(std::string_view text, std::string_view any, std::size_t from = 0) {
  int depth = 0;
  for (std::size_t at = from; at < text.size(); ++at) {
    if (depth == 0 && any.find(text[at]) != npos) return at;
    if (text[at] == '<' || text[at] == '(') ++depth;
    if (text[at] == '>' || text[at] == ')') --depth;
  }
  return npos;
}

std::string trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return std::string(text);
}

std::string parameter_types(std::string_view parameters) {
  static const std::regex named(R"((.*[ &*>])\w+)");
  std::string types;
  for (std::size_t from = 0; from <= parameters.size();) {
    const std::size_t end = std::min(find_outside(parameters, ",", from), parameters.size());
    const std::string_view whole = parameters.substr(from, end - from);
    const std::string one = trimmed(whole.substr(0, find_outside(whole, "=")));
    std::smatch match;
    types += (std::regex_match(one, match, named) ? trimmed(match[1].str()) : one) + ", ";
    from = end + 1;
  }
  return types;
}

// A statement at namespace scope, without the inside of its braces.
class Statement {
 public:
  explicit Statement(std::string_view text) : text_(trimmed(text)) {
    if (text_.starts_with("template <")) text_ = trimmed(text_.substr(find_outside(text_, " ", 9)));
    open_ = find_outside(text_, "({=");
  }

  bool is_function() const { return open_ < text_.size() && text_[open_] == '('; }

  std::optional<Declaration> declaration(bool is_anonymous) const {
    static const std::regex other(
        "(using|namespace|struct|class|enum|typedef|friend)\\b.*|.*\\boperator\\b.*");
    static const std::regex type_and_name(R"(.*[ &*>](\w+) *(?:\[.*\])? *)");
    const std::string head = text_.substr(0, open_);
    std::smatch match;
    if (std::regex_match(head, other) || !std::regex_match(head, match, type_and_name)) return {};
    return Declaration{match[1], is_function(), is_anonymous, is_function() ? parameters() : ""};
  }

 private:
  std::string parameters() const {
    const std::size_t close = find_outside(text_, ")", open_ + 1);
    return parameter_types(std::string_view(text_).substr(open_ + 1, close - open_ - 1));
  }

  std::string text_;
  std::size_t open_ = 0;  // the first ( { or =
};

// Takes a source apart, brace by brace.
class Reader {
 public:
  std::vector<Declaration> read(const std::string& text) {
    for (const char c : text) {
      if (c == '{')
        open();
      else if (c == '}')
        close();
      else if (bodies_ == 0 && c == ';')
        end_statement();
      else if (bodies_ == 0)
        statement_ += c;
    }
    return std::move(found_);
  }

 private:
  // A body ends the statement of a function; one of a type or a variable goes on to a semicolon.
  // A brace after `namespace` or `namespace name` opens a scope, others a body, which is skipped.
  void open() {
    static const std::regex space(R"( *(?:inline )?namespace ?([\w:]*) *)");
    std::smatch match;
    if (bodies_ == 0 && std::regex_match(statement_, match, space)) {
      anonymous_.push_back(match[1].length() == 0);
      statement_.clear();
    } else if (bodies_++ == 0) {
      statement_ += '{';
    }
  }

  void close() {
    if (bodies_ == 0) {
      statement_.clear();
      if (!anonymous_.empty()) anonymous_.pop_back();
    } else if (--bodies_ == 0 && Statement(statement_).is_function()) {
      end_statement();
    }
  }

  void end_statement() {
    const bool is_anonymous = std::ranges::find(anonymous_, true) != anonymous_.end();
    if (const auto declaration = Statement(statement_).declaration(is_anonymous))
      found_.push_back(*declaration);
    statement_.clear();
  }

  std::vector<Declaration> found_;
  std::vector<bool> anonymous_;  // of every open namespace
  int bodies_ = 0;               // open braces that are no namespaces
  std::string statement_;
};

}  // namespace

std::vector<Declaration> declarations_of(std::string_view source) {
  return Reader{}.read(bare(source));
}

}  // namespace hackle
