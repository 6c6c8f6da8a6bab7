// SPDX-License-Identifier: MIT
// What was measured of a plate, for a fit: a number, a place, or a path from a table.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "study/quantity.hpp"

namespace hackle {

struct Measurement {
  QuantityRow row;
  QuantityValue value;
  std::optional<double> sigma;  // standard deviation, in the unit of the row
  std::string text;             // as written

  // The number of residuals: 1 of a number, 2 of a place, 2 per point of a path.
  Eigen::Index size() const;
  // Differences of a run to it over `deviation`, in the unit of the row. Those of a path are the
  // ways from its points to the nearest points of the paths of the run, divided by the root of
  // their number besides: a path weighs as much as a number. Nothing if the run did not find the
  // quantity.
  std::optional<Eigen::VectorXd> residuals(const Outcome& outcome, double deviation) const;
};

// Reads NAME=VALUE: a number with its unit, as in fork.time=22us, a place, as in
// fork.place=67mm,20mm, or the name of a CSV file with columns x and y whose heads may name a unit,
// as in x_mm or "y (mm)", else m. At most 60 points, evenly spaced among those of the file, count.
// Throws Error (usage, files).
Measurement measurement_of(std::string_view word);

// Sets the deviation of that one by "NAME=VALUE". Throws Error (usage) if there is none of that
// name.
void set_sigma(std::vector<Measurement>& all, std::string_view word);

}  // namespace hackle
