// SPDX-License-Identifier: MIT
#include "study/case.hpp"

#include <cmath>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {
namespace {

constexpr auto spacing_key = "simulate.spacing", horizon_key = "simulate.horizon";

// A bare number, which is in SI.
std::optional<double> bare_number(const Settings& settings, const std::string& key) {
  const auto at = settings.find(key);
  if (at == settings.end()) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(at->second.c_str(), &end);
  const bool whole = end != at->second.c_str() && *end == '\0';
  return whole ? std::optional(value) : std::nullopt;
}

// "m 4" says more than a horizon.
std::vector<std::string> lattice_words(const Settings& settings) {
  const auto spacing = bare_number(settings, spacing_key);
  const auto horizon = bare_number(settings, horizon_key);
  std::vector<std::string> words;
  if (spacing) words.push_back("spacing " + quantity(*spacing, "m"));
  if (spacing && horizon)
    words.push_back(fmt::format("m {:.3g}", *horizon / *spacing));
  else if (horizon)
    words.push_back("horizon " + quantity(*horizon, "m"));
  return words;
}

std::string word_of(const std::string& key, const std::string& value) {
  const std::size_t dot = key.rfind('.');
  std::string name = dot == std::string::npos ? key : key.substr(dot + 1);
  if (key == "simulate.precision") return value;
  if (value == "true") return name;
  return value == "false" ? "not " + name : fmt::format("{} {}", name, value);
}

}  // namespace

std::string name_of(const Settings& settings) {
  std::vector<std::string> words = lattice_words(settings);
  for (const auto& [key, value] : settings) {
    const bool told = (key == spacing_key || key == horizon_key) && bare_number(settings, key);
    if (!told) words.push_back(word_of(key, value));
  }
  return words.empty() ? "as written" : fmt::format("{}", fmt::join(words, ", "));
}

Settings joined(Settings first, const Settings& second) {
  for (const auto& [key, value] : second) first[key] = value;
  return first;
}

}  // namespace hackle
