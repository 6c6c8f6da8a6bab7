// SPDX-License-Identifier: MIT
// The range of a colour bar, from the values that are going to be seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "output/picture/picture.hpp"
#include "solver/simulation.hpp"

namespace hackle {

// Takes in the states of one picture, or of all pictures of a movie, in any number and order: it
// keeps a count of values by size, not the values, so that ends are found to 1/500 of themselves.
class AutomaticRange {
 public:
  // `options.percentile` is the share of the values that the range spans, 50..100; the rest lies
  // half below and half above. On a logarithmic scale values up to 0 do not count.
  explicit AutomaticRange(const PictureOptions& options);

  // Throws what field_values throws.
  void add(const Simulation& simulation);

  // Colours that diverge get a range about the value in their middle: 0, or that of the field, 1
  // for strength. Where all values are the same it is what suits the field. Needs one add().
  Ends ends() const;

 private:
  double value_at(double share) const;
  std::optional<double> middle() const;

  PictureOptions options_;
  std::vector<std::int64_t> counts_;
  std::int64_t values_ = 0;
  double min_, max_;
  Ends usual_;
};

// The same of one state.
Ends automatic_range(const PictureOptions& options, const Simulation& simulation);

}  // namespace hackle
