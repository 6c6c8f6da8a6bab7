// SPDX-License-Identifier: MIT
#include "console/schema/option_row.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

std::string_view type_word(OptionType type) {
  switch (type) {
    case OptionType::number:
      return "number";
    case OptionType::integer:
      return "integer";
    case OptionType::text:
    case OptionType::caption:
      return "text";
    case OptionType::texts:
      return "list of texts";
    case OptionType::flag:
      return "flag";
    case OptionType::point:
      return "{x, y}";
    case OptionType::pair:
      return "{a, b}";
    case OptionType::window:
      return "{x, y, half}";
    case OptionType::points:
      return "points or file";
    case OptionType::markers:
      return "markers";
    case OptionType::numbers:
      return "list of numbers";
    case OptionType::recordings:
      return "list of recordings";
    case OptionType::sources:
      return "list of sources";
    case OptionType::columns:
      return "columns";
    case OptionType::choice:
      return "choice";
    case OptionType::material:
      return "material";
    case OptionType::areas:
      return "area or list of areas";
    case OptionType::vector_field:
      return "{x, y} or function";
    case OptionType::scalar_field:
      return "number or function";
    case OptionType::amplitude:
      return "times or function";
    case OptionType::function:
      return "function";
    case OptionType::reading:
      return "number, list or function";
  }
  return "?";
}

// For lists the range is that of their length.
std::string values_text(const Option& option) {
  const bool list = option.type == OptionType::points || option.type == OptionType::texts ||
                    option.type == OptionType::markers || option.type == OptionType::numbers ||
                    option.type == OptionType::recordings || option.type == OptionType::sources;
  if (list && option.unit.empty()) return shortest(option.range.min) + " or more";
  if (list) return fmt::format("{} or more, {}", shortest(option.range.min), option.unit);
  if (option.type == OptionType::choice) return comma_list(option.choices);
  const std::string range = range_text(option);
  return range.empty() ? std::string(option.unit) : range;
}

std::string presence_text(const Option& option) {
  if (!option.unless.empty()) return fmt::format("required, or {}", option.unless);
  if (option.required) return "required";
  if (option.alternative) return "one way";
  return option.fallback.empty() ? "optional" : fmt::format("default {}", option.fallback);
}

std::size_t widest(const std::vector<OptionRow>& rows, std::string OptionRow::*column) {
  std::size_t width = 0;
  for (const OptionRow& row : rows) width = std::max(width, (row.*column).size());
  return width;
}

// Formats one line per option, for a wide terminal.
std::string wide_table(const std::vector<OptionRow>& rows) {
  const std::size_t name = widest(rows, &OptionRow::name), type = widest(rows, &OptionRow::type);
  const std::size_t values = widest(rows, &OptionRow::values);
  const std::size_t presence = widest(rows, &OptionRow::presence);
  std::string text;
  for (const OptionRow& row : rows)
    text += fmt::format("  {:<{}}  {:<{}}  {:<{}}  {:<{}}  {}\n", row.name, name, row.type, type,
                        row.values, values, row.presence, presence, row.sentence);
  return text;
}

// Formats two lines per option, with the sentence below.
std::string narrow_table(const std::vector<OptionRow>& rows, std::size_t width) {
  const std::size_t name = widest(rows, &OptionRow::name), type = widest(rows, &OptionRow::type);
  const std::size_t indent = name + 4;
  std::string text;
  for (const OptionRow& row : rows) {
    const std::string line = fmt::format("{:<{}}  {}{}{}", row.type, type, row.values,
                                         row.values.empty() ? "" : "; ", row.presence);
    text += fmt::format("  {:<{}}  {}\n{:{}}{}\n", row.name, name, hanging(line, indent, width), "",
                        indent, hanging(row.sentence, indent, width));
  }
  return text;
}

}  // namespace

OptionRow row_of(const Option& option) {
  return {std::string(option.name), std::string(type_word(option.type)), values_text(option),
          presence_text(option), std::string(option.sentence)};
}

std::string table_text(const std::vector<OptionRow>& rows, std::size_t width) {
  std::string text = wide_table(rows);
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1)
    if (text.find('\n', begin) - begin > width) return narrow_table(rows, width);
  return text;
}

}  // namespace hackle
