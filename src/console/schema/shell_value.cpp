// SPDX-License-Identifier: MIT
#include "console/schema/shell_value.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "base/units.hpp"
#include "console/lua/lua_tokens.hpp"

namespace hackle {
namespace {

struct NamedDimension {
  std::string_view name;  // as units() has it
  Dimension exponents;
};

constexpr auto named = std::to_array<NamedDimension>({
    {"mass", {1, 0, 0, 0}},
    {"length", {0, 1, 0, 0}},
    {"time", {0, 0, 1, 0}},
    {"angle", {0, 0, 0, 1}},
    {"force", {1, 1, -2, 0}},
    {"energy", {1, 2, -2, 0}},
    {"stress", {1, -1, -2, 0}},
});
constexpr auto base_units = std::to_array<std::string_view>({"kg", "m", "s", "rad"});

const Unit* find_unit(std::string_view name) {
  const auto all = units();
  const auto unit = std::ranges::find(all, name, &Unit::name);
  return unit == all.end() ? nullptr : &*unit;
}

Dimension dimension_of(const Unit& unit) {
  return std::ranges::find(named, unit.dimension, &NamedDimension::name)->exponents;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Returns the size of the decimal number that the text begins with, 0 if it does not.
std::size_t number_size(std::string_view text) {
  std::size_t at = 0;
  const auto digits = [&] {
    const std::size_t from = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    return at > from;
  };
  if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
  const bool whole = digits();
  bool fraction = false;
  if (at < text.size() && text[at] == '.') {
    ++at;
    fraction = digits();
  }
  if (!whole && !fraction) return 0;
  const std::size_t mantissa = at;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
    if (!digits()) return mantissa;
  }
  return at;
}

struct Measured {
  std::string_view number, unit;  // the unit may be empty
};

// Takes "24MPa" apart; returns nothing for any other text.
std::optional<Measured> measured(std::string_view text) {
  const std::size_t size = number_size(text);
  if (size == 0) return std::nullopt;
  Measured value{text.substr(0, size), text.substr(size)};
  while (value.unit.starts_with(' ')) value.unit.remove_prefix(1);
  if (!value.unit.empty() && find_unit(value.unit) == nullptr) return std::nullopt;
  return value;
}

std::string product(std::string_view number, std::string_view unit) {
  return unit.empty() ? std::string(number) : fmt::format("{}*{}", number, unit);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0;;) {
    const std::size_t at = std::min(text.find(separator, from), text.size());
    parts.push_back(text.substr(from, at - from));
    if (at == text.size()) return parts;
    from = at + 1;
  }
}

// Returns the list of values between separators, or nothing if it is none.
std::optional<std::string> list(std::string_view text, char separator) {
  std::vector<Measured> values;
  for (const std::string_view part : split(text, separator)) {
    const auto value = measured(part);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  if (values.size() < 2) return std::nullopt;
  std::string expression;
  for (const Measured& value : values)
    expression +=
        fmt::format("{}{}", expression.empty() ? "{" : ", ",
                    product(value.number, value.unit.empty() ? values.back().unit : value.unit));
  return expression + "}";
}

// Returns what stands between the commas in the braces of the first call options { ... }.
std::vector<std::vector<Token>> entries_of(const std::vector<Token>& tokens) {
  constexpr auto call = std::to_array<std::string_view>({"options", "{"});
  const auto same = [](const Token& token, std::string_view word) { return token.is(word); };
  auto token = std::search(tokens.begin(), tokens.end(), call.begin(), call.end(), same);
  std::vector<std::vector<Token>> entries;
  int depth = 0;
  for (; token != tokens.end(); ++token) {
    if (depth == 1 && token->is("}")) return entries;
    if (token->is("{") || token->is("(")) ++depth;
    if (token->is("}") || token->is(")")) --depth;
    if (depth == 1 && (token->is(",") || token->is(";") || entries.empty()))
      entries.emplace_back();
    else if (!entries.empty())
      entries.back().push_back(*token);
  }
  return entries;
}

}  // namespace

std::string shell_expression(std::string_view value) {
  if (const auto one = measured(value)) return product(one->number, one->unit);
  for (const char separator : {':', ','})
    if (const auto several = list(value, separator)) return *several;
  return std::string(value);
}

std::optional<Dimension> dimension_of(std::string_view expression) {
  Dimension sum{};
  int sign = 1;
  bool expects_factor = true;
  for (const Token& token : tokens_of(expression).list) {
    if (expects_factor && token.is("-")) continue;
    if (!expects_factor && (token.is("*") || token.is("/"))) {
      sign = token.is("*") ? 1 : -1;
    } else if (expects_factor && token.kind == Token::Kind::name) {
      const Unit* unit = find_unit(token.word);
      if (unit == nullptr) return std::nullopt;
      const Dimension factor = dimension_of(*unit);
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += sign * factor[k];
    } else if (!expects_factor || token.kind != Token::Kind::number) {
      return std::nullopt;
    }
    expects_factor = token.is("*") || token.is("/");
  }
  if (expects_factor) return std::nullopt;
  return sum;
}

std::string dimension_name(const Dimension& dimension) {
  if (dimension == no_dimension) return "number without a unit";
  const auto known = std::ranges::find(named, dimension, &NamedDimension::exponents);
  if (known != named.end()) return std::string(known->name);
  std::string text;
  for (std::size_t k = 0; k < dimension.size(); ++k)
    if (dimension[k] != 0)
      text += fmt::format("{}{}{}", text.empty() ? "" : " ", base_units[k],
                          dimension[k] == 1 ? "" : std::to_string(dimension[k]));
  return text;
}

std::string option_expression(std::string_view script, std::string_view name) {
  const std::vector<Token> tokens = tokens_of(script).list;
  for (const std::vector<Token>& entry : entries_of(tokens)) {
    if (entry.size() < 3 || !entry[0].is(name) || !entry[1].is("=")) continue;
    const std::string_view last = entry.back().word;
    return {entry[2].word.data(), last.data() + last.size()};
  }
  return "";
}

}  // namespace hackle
