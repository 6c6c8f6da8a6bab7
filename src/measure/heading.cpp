// SPDX-License-Identifier: MIT
#include "measure/heading.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace hackle {
namespace {

// Of all columns. A unit stands before those that it ends with.
constexpr auto known_units =
    std::to_array<std::string_view>({"Pa sqrt(m)", "J/m3", "J/m2", "J/m", "N/m", "rad/s", "m/s",
                                     "m2", "kg/m", "rad", "kg", "Pa", "N", "K", "m", "s"});

std::string in_words(std::string_view unit) {
  using Change = std::pair<std::string_view, std::string_view>;
  std::string text(unit);
  for (const auto& [sign, words] : {Change{"/", "_per_"}, Change{" sqrt(m)", "_sqrt_m"}})
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at))
      text.replace(at, sign.size(), words);
  return text;
}

std::string without_dots(std::string_view name) {
  std::string text(name);
  std::ranges::replace(text, '.', '_');
  return text;
}

std::string_view unit_at_end(std::string_view heading) {
  for (const std::string_view unit : known_units)
    if (const std::string end = fmt::format("_{}", in_words(unit));
        heading.size() > end.size() && heading.ends_with(end))
      return unit;
  return "";
}

}  // namespace

std::string heading_of(std::string_view name, std::string_view unit) {
  const std::string text = without_dots(name);
  return unit.empty() ? text : fmt::format("{}_{}", text, in_words(unit));
}

std::string name_in_heading(std::string_view heading) {
  const std::string_view unit = unit_at_end(heading);
  if (unit.empty()) return std::string(heading);
  return std::string(heading.substr(0, heading.size() - in_words(unit).size() - 1));
}

std::optional<std::string> unit_in_heading(std::string_view heading, std::string_view name) {
  const std::string wanted = without_dots(name);
  if (without_dots(heading) != wanted && without_dots(name_in_heading(heading)) != wanted)
    return std::nullopt;
  return std::string(unit_at_end(heading));
}

}  // namespace hackle
