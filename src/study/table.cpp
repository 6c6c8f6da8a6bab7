// SPDX-License-Identifier: MIT
#include "study/table.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace hackle {
namespace {

// Of UTF-8, one column a code point.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char byte) { return (byte & 0xC0) != 0x80; }));
}

std::string escaped(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"') quoted += '"';
    quoted += letter;
  }
  quoted += '"';
  return quoted;
}

std::vector<std::size_t> widths_of(const Table& table) {
  std::vector<std::size_t> widths;
  for (const std::string& head : table.heads) widths.push_back(width_of(head));
  for (const auto& row : table.rows)
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], width_of(row[k]));
  return widths;
}

std::string line_of(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::size_t blanks = widths[k] - width_of(cells[k]);
    const bool is_last = k > 0 && k + 1 == widths.size();
    if (is_last)
      fmt::format_to(std::back_inserter(line), "  {}", cells[k]);
    else if (k == 0)
      fmt::format_to(std::back_inserter(line), "{}{:{}}", cells[k], "", blanks);
    else
      fmt::format_to(std::back_inserter(line), "  {:{}}{}", "", blanks, cells[k]);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  line += '\n';
  return line;
}

}  // namespace

std::string aligned(const Table& table) {
  const std::vector<std::size_t> widths = widths_of(table);
  std::string text = line_of(table.heads, widths);
  for (const auto& row : table.rows) text += line_of(row, widths);
  return text;
}

std::string csv_of(const Table& table) {
  std::string text;
  const auto add = [&text](const std::vector<std::string>& cells) {
    for (std::size_t k = 0; k < cells.size(); ++k)
      fmt::format_to(std::back_inserter(text), "{}{}", k == 0 ? "" : ",", escaped(cells[k]));
    text += '\n';
  };
  add(table.heads);
  for (const auto& row : table.rows) add(row);
  return text;
}

}  // namespace hackle
