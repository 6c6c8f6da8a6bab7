// SPDX-License-Identifier: MIT
// How the values that are seen fit the range of a colour bar.
#pragma once

#include <cstdint>
#include <span>

#include "render/overlay/colour_bar.hpp"
#include "render/picture_style.hpp"

namespace hackle {

// Values that are seen, with the share of their cells that is open, in 1/255, if cracks are gaps;
// else that is empty. nan, and what lies in a gap, is not seen.
struct Seen {
  std::span<const float> values;
  std::span<const std::uint8_t> gaps;
};

// Returns at which ends of the range values lie beyond it.
Beyond beyond(const FieldStyle& field, const Seen& seen);

// Returns by how much the range of the field must grow until at most 1 % of the values lie beyond
// it: 1, 2, 5, 10, 20, ... times; 1 if the field does not widen.
double widening(const FieldStyle& field, const Seen& seen);

// Returns the field with a range as many times as wide: about 0 if it contains values of two signs,
// else from its lower end.
FieldStyle widened(FieldStyle field, double times);

}  // namespace hackle
