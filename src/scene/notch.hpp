// SPDX-License-Identifier: MIT
// Notches: material removed from the edge of a plate inwards.
#pragma once

#include <array>
#include <string_view>

#include "scene/plate.hpp"

namespace hackle {

struct Notch {
  // Two straight sides with a flat end, a sharp tip, or a round end.
  enum class Kind { slot, v, u };
  Vec2 at{0, 0};       // m, on an edge of the plate
  double depth = 0.0;  // m, > 0, from `at` to the tip
  double width = 0.0;  // m, > 0, across the notch; of a V at its mouth
  Kind kind = Kind::slot;
  double angle = 0.0;  // rad, anticlockwise from the inward normal of the edge; in a corner from
                       // the diagonal between the two edges
};
inline constexpr std::array<std::string_view, 3> notch_names{"slot", "v", "u"};

// Returns the removed area; it begins outside the plate, so that no sliver remains at the edge.
Shape shape_of(const Notch& notch, const Plate& plate);

// Adds a problem if the notch does not begin on an edge, or one of its sides would not reach that
// edge.
void check(const Plate& plate, const Notch& notch, Problems& problems);

}  // namespace hackle
