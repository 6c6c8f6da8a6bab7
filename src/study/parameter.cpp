// SPDX-License-Identifier: MIT
#include "study/parameter.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

constexpr std::size_t most_values = 10000;

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

const Unit* unit_named(std::string_view name) {
  const auto all = units();
  const auto unit = std::ranges::find(all, name, &Unit::name);
  return unit == all.end() ? nullptr : &*unit;
}

// The size of a unit such as "J/m2".
std::optional<double> factor_of(std::string_view unit) {
  double factor = 1.0;
  if (unit.empty()) return factor;
  char sign = '*';
  if (unit.front() == '*') unit.remove_prefix(1);
  for (std::size_t from = 0; from <= unit.size();) {
    const std::size_t to = std::min(unit.find_first_of("*/", from), unit.size());
    std::string_view name = unit.substr(from, to - from);
    int power = 1;
    if (!name.empty() && name.back() >= '2' && name.back() <= '9') {
      power = name.back() - '0';
      name.remove_suffix(name.ends_with('^') ? 2 : 1);
      if (name.ends_with('^')) name.remove_suffix(1);
    }
    const Unit* known = unit_named(name);
    if (known == nullptr) return std::nullopt;
    factor *= std::pow(known->factor, sign == '*' ? power : -power);
    if (to == unit.size()) break;
    sign = unit[to];
    from = to + 1;
  }
  return factor;
}

// The SI unit that the numbers of a unit have in charts: that of one factor alone.
std::string si_unit_of(std::string_view unit) {
  constexpr std::string_view bases[][2] = {{"length", "m"}, {"time", "s"},  {"stress", "Pa"},
                                           {"mass", "kg"},  {"force", "N"}, {"energy", "J"},
                                           {"angle", "rad"}};
  const Unit* known = unit_named(unit);
  if (known != nullptr)
    for (const auto& [dimension, name] : bases)
      if (known->dimension == dimension) return std::string(name);
  return unit == "J/m2" || unit == "J/m^2" ? "J/m2" : "";
}

std::vector<std::string_view> divided(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  int depth = 0;
  bool is_quoted = false;
  std::size_t from = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '"') is_quoted = !is_quoted;
    if (std::string_view("{([").find(text[k]) != std::string_view::npos) ++depth;
    if (std::string_view("})]").find(text[k]) != std::string_view::npos) --depth;
    if (text[k] != separator || depth > 0 || is_quoted) continue;
    parts.push_back(trimmed(text.substr(from, k - from)));
    from = k + 1;
  }
  parts.push_back(trimmed(text.substr(from)));
  return parts;
}

[[noreturn]] void refuse(std::string_view word, std::string_view what, std::string remedy = {}) {
  throw Error(ErrorKind::usage, fmt::format("'{}': {}", word, what), std::move(remedy));
}

// Returns nothing unless all parts are numbers; they have one unit, then.
std::optional<std::vector<Measure>> measures_of(const std::vector<std::string_view>& parts) {
  std::vector<Measure> all;
  for (const std::string_view part : parts) {
    const auto one = measure_of(part);
    if (!one) return std::nullopt;
    all.push_back(*one);
  }
  for (Measure& one : all)
    if (one.unit.empty()) one.unit = all.back().unit, one.factor = all.back().factor;
  return all;
}

ParameterRange range_of(std::string_view word, const std::vector<Measure>& ends) {
  const Measure& last = ends.back();
  const auto in_unit = [&](const Measure& one) { return one.value() / last.factor; };
  ParameterRange range{
      .from = in_unit(ends[0]), .to = in_unit(ends[1]), .unit = last.unit, .factor = last.factor};
  for (Measure one : ends)
    if (si_unit_of(one.unit) != si_unit_of(last.unit))
      refuse(word, fmt::format("'{}' and '{}' are not of a kind", one.unit, last.unit));
  if (ends.size() > 2) range.step = std::abs(ends[2].number * ends[2].factor / last.factor);
  if (range.from == range.to) refuse(word, "the range has no width");
  if (ends.size() > 2 && range.step == 0.0) refuse(word, "the step is 0");
  return range;
}

void fill_from_range(std::string_view word, Parameter& parameter) {
  const ParameterRange& range = *parameter.range;
  if (range.step == 0.0) return;
  const double width = std::abs(range.to - range.from);
  const double count = std::floor(width / range.step * (1.0 + 1e-12) + 1e-9) + 1.0;
  if (count > static_cast<double>(most_values)) refuse(word, "it has more than 10 000 values");
  const double step = range.to > range.from ? range.step : -range.step;
  for (double k = 0.0; k < count; ++k) {
    const double number = range.from + k * step;
    parameter.values.push_back({range.text(number), number * range.factor});
  }
}

void fill_from_list(const std::vector<std::string_view>& parts, Parameter& parameter) {
  if (const auto all = measures_of(parts); all && parts.size() > 1) {
    parameter.unit = si_unit_of(all->back().unit);
    for (const Measure& one : *all) {
      const ParameterRange same{.unit = one.unit, .factor = one.factor};
      parameter.values.push_back({same.text(one.number), one.value()});
    }
    return;
  }
  for (const std::string_view part : parts) {
    const auto one = measure_of(part);
    if (one) parameter.unit = si_unit_of(one->unit);
    parameter.values.push_back(
        {std::string(part), one ? std::optional(one->value()) : std::nullopt});
  }
}

}  // namespace

std::optional<Measure> measure_of(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  Measure result;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), result.number);
  if (failed != std::errc() || !std::isfinite(result.number)) return std::nullopt;
  const std::string_view unit = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
  const auto factor = factor_of(unit);
  if (!factor) return std::nullopt;
  result.unit = unit.substr(unit.starts_with('*') ? 1 : 0);
  result.factor = *factor;
  return result;
}

// Twelve digits: a sum of steps must not show its rounding.
std::string ParameterRange::text(double number) const {
  if (unit.empty() || unit_named(unit) != nullptr) return fmt::format("{:.12g}{}", number, unit);
  return fmt::format("{:.12g}", number * factor);
}

Parameter parameter_of(std::string_view word, bool pairs_are_ranges) {
  const std::size_t equals = word.find('=');
  if (equals == 0 || equals == std::string_view::npos || equals + 1 == word.size())
    refuse(word, "it is not key=value", "as in --set load=6:24:2MPa or --set m=3,4,6");
  Parameter parameter{.key = std::string(word.substr(0, equals))};
  const std::string_view value = word.substr(equals + 1);
  const auto ends = divided(value, ':');
  const bool may_be_range = ends.size() == 3 || (ends.size() == 2 && pairs_are_ranges);
  if (may_be_range)
    if (const auto measures = measures_of(ends)) {
      parameter.range = range_of(word, *measures);
      parameter.unit = si_unit_of(parameter.range->unit);
      fill_from_range(word, parameter);
      return parameter;
    }
  if (ends.size() == 3 && measure_of(ends[0]))
    refuse(word, "it looks like a range FROM:TO:STEP, but is none",
           "as in 6:24:2MPa; the units are those of the scene language");
  fill_from_list(divided(value, ','), parameter);
  return parameter;
}

Parameter ranged_parameter_of(std::string_view word) {
  Parameter parameter = parameter_of(word, true);
  if (!parameter.range) refuse(word, "it is no range", "as in load=6:24MPa");
  return parameter;
}

std::vector<Settings> combinations(const std::vector<Parameter>& parameters) {
  std::vector<Settings> all{{}};
  for (const Parameter& parameter : parameters) {
    if (all.size() * parameter.values.size() > most_values)
      throw Error(ErrorKind::usage, "there are more than 10 000 combinations",
                  "take fewer values, or larger steps");
    std::vector<Settings> next;
    for (const Settings& settings : all)
      for (const ParameterValue& value : parameter.values)
        next.push_back(joined(settings, {{parameter.key, value.text}}));
    all = std::move(next);
  }
  return all;
}

}  // namespace hackle
