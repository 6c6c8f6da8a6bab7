// SPDX-License-Identifier: MIT
#include "render/overlay/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <string_view>

#include <fmt/format.h>

namespace hackle {
namespace {

constexpr double slack = 1e-9;  // so that a round end gets its tick

double neat_at_least(double min, std::initializer_list<double> factors = {1.0, 2.0, 2.5, 5.0}) {
  const double decade = std::pow(10.0, std::floor(std::log10(min)));
  for (const double factor : factors)
    if (factor * decade >= min) return factor * decade;
  return 10.0 * decade;
}

double step_of(double min, double max, int intervals) {
  const double share = max / intervals - min / intervals;  // does not overflow
  return neat_at_least(share * (1.0 - slack));
}

std::vector<double> multiples(double step, double first, double last) {
  constexpr double max = 100.0;  // there are fewer, unless the numbers are too close to differ
  std::vector<double> values;
  if (!std::isfinite(step) || step == 0.0 || last - first > max) return values;
  for (double k = first; k <= last; ++k) values.push_back(k == 0.0 ? 0.0 : k * step);  // never -0
  return values;
}

// Writes "−" for "-", and powers of ten in the usual form.
std::string printed(const std::string& text) {
  const std::size_t e = text.find('e');
  std::string number = text.substr(0, e);
  if (number.starts_with('-')) number.replace(0, 1, "−");
  if (e == std::string::npos) return number;
  constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string power = number == "1" ? "10" : number + "·10";
  const int exponent = std::stoi(text.substr(e + 1));
  if (exponent < 0) power += "⁻";
  for (const char digit : std::to_string(std::abs(exponent))) power += raised[digit - '0'];
  return power;
}

}  // namespace

std::vector<double> neat_values(double min, double max, int intervals) {
  const double step = step_of(min, max, intervals);
  return multiples(step, std::ceil(min / step - slack), std::floor(max / step + slack));
}

std::vector<double> whole_values(double min, double max, int intervals) {
  const double share = (max / intervals - min / intervals) * (1.0 - slack);
  const double step = neat_at_least(std::max(share, 1.0), {1.0, 2.0, 5.0});
  return multiples(step, std::ceil(min / step - slack), std::floor(max / step + slack));
}

std::vector<double> enclosing_values(double min, double max, int intervals) {
  const double step = step_of(min, max, intervals);
  return multiples(step, std::floor(min / step + slack), std::ceil(max / step - slack));
}

std::vector<double> decades(double min, double max, int intervals) {
  const double first = std::ceil(std::log10(min) - slack);
  const double last = std::floor(std::log10(max) + slack);
  const double stride = std::max(1.0, std::ceil((last - first) / intervals));
  std::vector<double> values;
  for (double power = first; power <= last; power += stride)
    values.push_back(std::pow(10.0, power));
  return values;
}

std::vector<std::string> tick_texts(const std::vector<double>& values) {
  constexpr int fewest = 4, max = 12;
  std::vector<std::string> texts;
  for (int digits = fewest; digits <= max; ++digits) {
    texts.clear();
    for (const double value : values)
      texts.push_back(printed(fmt::format("{:.{}g}", value, digits)));
    if (std::ranges::adjacent_find(texts) == texts.end()) break;
  }
  return texts;
}

PrefixedUnit axis_unit(double size, const std::string& unit) {
  constexpr std::string_view per_metre = "/m";
  if (unit != "J/m" && unit != "N/m") return prefixed(size, unit);
  PrefixedUnit found = prefixed(size, unit.substr(0, 1));
  found.name += per_metre;
  return found;
}

}  // namespace hackle
