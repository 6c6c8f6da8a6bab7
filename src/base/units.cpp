// SPDX-License-Identifier: MIT
#include "base/units.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace hackle {
namespace {

constexpr std::array all_units{
    Unit{"m", 1.0, "length"},
    Unit{"cm", 1e-2, "length"},
    Unit{"mm", 1e-3, "length"},
    Unit{"um", 1e-6, "length"},
    Unit{"nm", 1e-9, "length"},
    Unit{"s", 1.0, "time"},
    Unit{"ms", 1e-3, "time"},
    Unit{"us", 1e-6, "time"},
    Unit{"ns", 1e-9, "time"},
    Unit{"Pa", 1.0, "stress"},
    Unit{"kPa", 1e3, "stress"},
    Unit{"MPa", 1e6, "stress"},
    Unit{"GPa", 1e9, "stress"},
    Unit{"kg", 1.0, "mass"},
    Unit{"g", 1e-3, "mass"},
    Unit{"N", 1.0, "force"},
    Unit{"kN", 1e3, "force"},
    Unit{"J", 1.0, "energy"},
    Unit{"deg", std::numbers::pi / 180.0, "angle"},
};

struct Prefix {
  double factor;
  std::string_view text;
};

constexpr std::array prefixes{Prefix{1e12, "T"}, Prefix{1e9, "G"},  Prefix{1e6, "M"},
                              Prefix{1e3, "k"},  Prefix{1.0, ""},   Prefix{1e-3, "m"},
                              Prefix{1e-6, "u"}, Prefix{1e-9, "n"}, Prefix{1e-12, "p"}};

// The largest and smallest prefix in customary use with a unit.
struct Habit {
  std::string_view unit;
  double max;
  double min;
};

constexpr std::array habits{Habit{"m", 1.0, 1e-9},   Habit{"s", 1.0, 1e-12},  Habit{"Pa", 1e9, 1.0},
                            Habit{"J", 1e9, 1e-9},   Habit{"J/m3", 1e9, 1.0}, Habit{"B", 1e12, 1.0},
                            Habit{"m/s", 1e3, 1e-6}, Habit{"N", 1e9, 1e-9}};

const Habit* habit_of(std::string_view unit) {
  for (const Habit& habit : habits)
    if (habit.unit == unit) return &habit;
  return nullptr;
}

// Returns the smallest number that is written with this prefix; below it the next smaller prefix is
// used. Engineers write 0.5 mm, not 500 um.
double min_number(std::string_view unit, const Prefix& prefix) {
  return unit == "m" && prefix.text == "m" ? 0.01 : 1.0;
}

const Prefix& prefix_for(double size, const Habit& habit) {
  const Prefix* chosen = &prefixes.back();
  for (const Prefix& prefix : prefixes) {
    if (prefix.factor > habit.max * 1.5 || prefix.factor < habit.min / 1.5) continue;
    chosen = &prefix;
    // Rounding to four digits must not turn 999.99 ns into 1000 ns.
    if (size >= min_number(habit.unit, prefix) * prefix.factor * 0.99995) break;
  }
  return *chosen;
}

}  // namespace

std::span<const Unit> units() {
  return all_units;
}

PrefixedUnit prefixed(double size, std::string_view unit) {
  const Habit* habit = habit_of(unit);
  if (habit == nullptr || size == 0.0 || !std::isfinite(size)) return {std::string(unit), 1.0};
  const Prefix& prefix = prefix_for(std::abs(size), *habit);
  return {fmt::format("{}{}", prefix.text, unit), prefix.factor};
}

std::string quantity(double value, std::string_view unit) {
  if (unit.empty()) return fmt::format("{:.4g}", value);
  const PrefixedUnit shown = prefixed(value, unit);
  return fmt::format("{:.4g} {}", value / shown.factor, shown.name);
}

std::string grouped(long long count) {
  std::string digits = std::to_string(count);
  const std::ptrdiff_t first = count < 0 ? 1 : 0;
  for (auto at = std::ssize(digits) - 3; at > first; at -= 3)
    digits.insert(static_cast<std::size_t>(at), 1, ' ');
  return digits;
}

std::string shortest(double value) {
  return fmt::format("{}", value);
}

}  // namespace hackle
