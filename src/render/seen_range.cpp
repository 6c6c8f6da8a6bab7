// SPDX-License-Identifier: MIT
#include "render/seen_range.hpp"

#include <cmath>

namespace hackle {
namespace {

// Of 255: from here on a cell shows the gap and not its value; see shaders/colours.frag.
constexpr std::uint8_t shows_gap = 102;

// Calls visit(value) for all values that are seen.
template <class Visit>
void for_seen(const Seen& seen, const Visit& visit) {
  for (std::size_t k = 0; k < seen.values.size(); ++k)
    if (!std::isnan(seen.values[k]) && (seen.gaps.empty() || seen.gaps[k] < shows_gap))
      visit(static_cast<double>(seen.values[k]));
}

// Values this close to an end, in units of the range, do not lie beyond it: they are rounded.
double rounding_of(const FieldStyle& field) {
  constexpr double share = 1e-6;
  return share * (field.max - field.min);
}

double share_beyond(const FieldStyle& field, const Seen& seen) {
  const bool low = field.min < 0.0;  // no range without negative values grows downwards
  std::int64_t all = 0, beyond = 0;
  for_seen(seen, [&](double value) {
    ++all;
    beyond += value > field.max || (low && value < field.min) ? 1 : 0;
  });
  return all == 0 ? 0.0 : static_cast<double>(beyond) / static_cast<double>(all);
}

}  // namespace

Beyond beyond(const FieldStyle& field, const Seen& seen) {
  const double min = field.min - rounding_of(field), max = field.max + rounding_of(field);
  Beyond found;
  for_seen(seen, [&](double value) {
    found.below |= value < min;
    found.above |= value > max;
  });
  return found;
}

double widening(const FieldStyle& field, const Seen& seen) {
  constexpr double most_beyond = 0.01, most = 1e9;
  if (!field.widens) return 1.0;
  for (double decade = 1.0; decade < most; decade *= 10.0)
    for (const double factor : {1.0, 2.0, 5.0})
      if (share_beyond(widened(field, factor * decade), seen) <= most_beyond)
        return factor * decade;
  return most;
}

FieldStyle widened(FieldStyle field, double times) {
  field.max = field.min < 0.0 ? times * field.max : field.min + times * (field.max - field.min);
  if (field.min < 0.0) field.min *= times;
  return field;
}

}  // namespace hackle
