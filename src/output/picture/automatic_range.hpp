// SPDX-License-Identifier: MIT
// Finds the range of a colour bar from the values that will be visible.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "output/picture/picture.hpp"
#include "solver/view.hpp"

namespace hackle {

// Takes the states of one picture, or of all pictures of a movie, in any number and order. It
// counts values by size instead of storing them, so that the ends are found to 1/500 of themselves.
class AutomaticRange {
 public:
  // `options.percentile` is the share of the values that the range spans, 50..100; half of the rest
  // lies below and half above. On a logarithmic scale values up to 0 are ignored.
  explicit AutomaticRange(const PictureOptions& options);

  // Throws what field_values throws.
  void add(const View& view);

  // Returns the range. Diverging colours get a range about their middle value: 0, or that of the
  // field, 1 for strength. If all values are equal, the range is the field's default. Requires one
  // add().
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

// Returns the range for one state.
Ends automatic_range(const PictureOptions& options, const View& view);

}  // namespace hackle
