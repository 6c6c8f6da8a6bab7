// SPDX-License-Identifier: MIT
// Settings that a study varies: ranges and lists of values as they are written on a command line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/case.hpp"

namespace hackle {

// A number with a unit: "24MPa", "2e-3", "300J/m2". The unit is a product or quotient of unit
// constants with exponents of one digit, or empty.
struct Measure {
  double number = 0.0;
  std::string unit;     // as written
  double factor = 1.0;  // of the unit in SI

  double value() const { return number * factor; }  // SI
};

// Returns nothing if the text is none.
std::optional<Measure> measure_of(std::string_view text);

// A range from one number to another, in the unit of the last.
struct ParameterRange {
  double from = 0.0, to = 0.0;  // in the unit, from different from to
  double step = 0.0;            // in the unit, above 0; 0: none was given
  std::string unit;
  double factor = 1.0;  // of the unit in SI

  // Returns a value of --set for a number in the unit: "8MPa"; in SI where the unit is a product.
  std::string text(double number) const;
};

struct ParameterValue {
  std::string text;              // for --set
  std::optional<double> number;  // SI, if it is one
};

// One key with the values that it takes.
struct Parameter {
  std::string key;
  std::vector<ParameterValue> values;  // one: it is fixed
  std::optional<ParameterRange> range;
  std::string unit;  // of the numbers in SI: "Pa", "" for a pure number or an unknown one

  bool varies() const { return values.size() > 1 || range; }
};

// Reads "key=value". What holds for the value, in this order:
//  - FROM:TO:STEP, three numbers, is a range; the unit of the last holds for all that have none.
//    FROM:TO is a range where `pairs_are_ranges`, else one value: a pair.
//  - A list with commas outside of braces, brackets and quotes is a list of values, each a case;
//    numbers without a unit have that of the last. A list as one value stands in braces: {1,2}.
//  - All else is one value, fixed.
// Throws Error (usage): a range that does not get anywhere, an unknown unit, too many values.
Parameter parameter_of(std::string_view word, bool pairs_are_ranges = false);

// Returns a range from "key=from:to[unit]". Throws Error (usage).
Parameter ranged_parameter_of(std::string_view word);

// Returns all combinations, those of the last parameter next to each other. Throws Error (usage)
// for more than 10 000.
std::vector<Settings> combinations(const std::vector<Parameter>& parameters);

}  // namespace hackle
