// SPDX-License-Identifier: MIT
#include "console/schema/point_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr const char* line_remedy =
    "each line holds x and y, two finite numbers with a decimal point, separated by a comma";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Takes the text up to a separator, and the separator, from the front of `rest`.
std::string_view take_up_to(std::string_view& rest, std::string_view separators) {
  const std::size_t end = std::min(rest.find_first_of(separators), rest.size());
  const std::string_view taken = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return taken;
}

// Returns the fields of a line, which is not empty; at most three, so that no line takes memory.
std::vector<std::string_view> fields_of(std::string_view line) {
  std::string_view separators = blanks;
  for (const std::string_view separator : {",", ";"})
    if (line.find(separator) != std::string_view::npos) separators = separator;
  std::vector<std::string_view> fields;
  while (!line.empty() && fields.size() < 3) {
    fields.push_back(trimmed(take_up_to(line, separators)));
    if (separators == blanks) line = trimmed(line);
  }
  return fields;
}

// Returns infinity for a number that no double holds: a line of such is no header.
std::optional<double> number_in(std::string_view field) {
  if (field.starts_with('+')) field.remove_prefix(1);
  double value = 0.0;
  const char* const end = field.data() + field.size();
  const auto [rest, failure] = std::from_chars(field.data(), end, value);
  if (failure == std::errc::result_out_of_range) value = HUGE_VAL;
  return failure != std::errc::invalid_argument && rest == end ? std::optional(value)
                                                               : std::nullopt;
}

std::optional<Vec2> point_in(const std::vector<std::string_view>& fields) {
  if (fields.size() != 2) return std::nullopt;
  const std::optional<double> x = number_in(fields[0]), y = number_in(fields[1]);
  if (!x || !y || !std::isfinite(*x) || !std::isfinite(*y)) return std::nullopt;
  return Vec2{*x, *y};
}

bool is_header(const std::vector<std::string_view>& fields) {
  return std::ranges::none_of(fields,
                              [](std::string_view field) { return number_in(field).has_value(); });
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

[[noreturn]] void refuse(const std::string& what, const std::string& remedy = {}) {
  throw Error(ErrorKind::files, what, remedy);
}

}  // namespace

std::vector<Vec2> points_in_text(std::string_view text, std::size_t max, const std::string& who) {
  std::vector<Vec2> points;
  bool may_be_header = true;
  text = without_byte_order_mark(text);
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = trimmed(take_up_to(text, "\n"));
    if (line.empty() || line.starts_with('#')) continue;
    const std::vector<std::string_view> fields = fields_of(line);
    const std::optional<Vec2> point = point_in(fields);
    if (!point && !(may_be_header && is_header(fields)))
      refuse(fmt::format("{}, line {} is no point", who, number), line_remedy);
    may_be_header = false;
    if (point && points.size() == max)
      refuse(fmt::format("{}, line {}: there are more than {} points", who, number, max),
             "leave out points that lie closer together than the spacing");
    if (point) points.push_back(*point);
  }
  return points;
}

std::vector<Vec2> read_point_file(const fs::path& path, std::size_t max) {
  throw_if_interrupted();
  const std::string who = fmt::format("'{}'", path.string());
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (!fs::exists(status))
    refuse(fmt::format("cannot read {}: no such file", who),
           "its place is relative to the folder of the script");
  if (fs::is_directory(status)) refuse(fmt::format("cannot read {}: it is a folder", who));
  if (!fs::is_regular_file(status)) refuse(fmt::format("{} is no plain file", who));
  if (fs::file_size(path, failure) > max_point_file && !failure)
    refuse(fmt::format("{} is larger than {} MiB", who, max_point_file >> 20U),
           fmt::format("a list of points has at most {}", max));
  return points_in_text(read_text(path), max, who);
}

}  // namespace hackle
