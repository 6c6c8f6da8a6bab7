// SPDX-License-Identifier: MIT
#include "base/described.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {
namespace {

std::string with_unit(double value, std::string_view unit) {
  return unit.empty() ? shortest(value) : fmt::format("{} {}", shortest(value), unit);
}

}  // namespace

std::string range_text(const Range& range, std::string_view unit) {
  const bool low = std::isfinite(range.min), high = std::isfinite(range.max);
  const std::string max = high ? with_unit(range.max, unit) : "";
  if (low && high && range.min_inclusive && range.max_inclusive)
    return fmt::format("between {} and {}", shortest(range.min), max);
  const std::string above = range.min_inclusive ? "at least " : "above ";
  const std::string below = range.max_inclusive ? "at most " : "below ";
  if (low && high) return above + shortest(range.min) + " and " + below + max;
  if (high) return below + max;
  return low ? above + with_unit(range.min, unit) : "";
}

std::optional<std::string> objection(std::string_view who, std::string_view name, double value,
                                     std::string_view unit, const Range& range) {
  if (!std::isfinite(value))
    return fmt::format("{}: {} is {}, expected a finite number{}{}", who, name,
                       std::isnan(value) ? "nan" : shortest(value), unit.empty() ? "" : " in ",
                       unit);
  if (range.holds(value)) return std::nullopt;
  return fmt::format("{}: {} is {}, it must be {}", who, name, quantity(value, unit),
                     range_text(range, unit));
}

}  // namespace hackle
