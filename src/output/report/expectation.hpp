// SPDX-License-Identifier: MIT
// An expectation of a scene: a quantity, its value by some source, its value here, and the verdict.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/described.hpp"

namespace hackle {

// unsupported: Hackle cannot compute it; the reason says why.
enum class Verdict { pass, fail, unsupported };
template <>
inline constexpr auto enum_names<Verdict> = std::to_array<std::string_view>({"pass", "fail",
                                                                             "unsupported"});

// The same quantity along an axis; lists of equal length, empty without a curve.
struct ExpectedCurve {
  std::string along;  // name of the axis with its unit: "distance from the hole in mm"
  std::vector<double> x, expected, got;
};

struct Expectation {
  std::string name;      // of the scene
  std::string quantity;  // "place of the fork"
  std::string unit;  // of all its numbers; SI units are shown with a prefix, any other text as is
  // What the source says, if that is one number. A curve has the numbers of its worst point here.
  std::optional<double> expected;
  double tolerance = 0.0;  // around it
  double relative = 0.0;   // the same as a share of it, if it was given so
  // What passes where the source gives bounds.
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  std::optional<double> got;  // nothing: not found, or no finite number
  std::string source;
  bool confirmed = true;  // false: nobody has read the source itself
  std::string reason;     // why it fails or is unsupported; "" if nobody has said
  bool unsupported = false;
  ExpectedCurve curve;

  Verdict verdict() const;
  // Returns where it lies between the bounds: -1 and 1 at them, 0 in the middle; nothing if there
  // are not two, or nothing was found.
  std::optional<double> deviation() const;
};

// "67 mm", "60 to 70 deg", "at least 2".
std::string expected_text(const Expectation& expectation);
// "1 %", "0.5 us", "exact"; "" for bounds.
std::string tolerance_text(const Expectation& expectation);
// "66.4 mm", "nothing".
std::string got_text(const Expectation& expectation);
// Returns the source, marked if it is unconfirmed.
std::string source_text(const Expectation& expectation);
// One line for a person: "pass  place of the fork: 66.4 mm, expected 67 mm within 1 mm (source)".
std::string line_of(const Expectation& expectation);

// Returns the object documented in README.md, "--json".
nlohmann::ordered_json to_json(const Expectation& expectation);

}  // namespace hackle
