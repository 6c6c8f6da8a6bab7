// SPDX-License-Identifier: MIT
// Material removed from the edge of a plate inwards.
#pragma once

#include <array>
#include <string_view>

#include "scene/plate.hpp"

namespace hackle {

struct Notch {
  // Two straight sides and a flat end, a sharp tip, or two straight sides and a round end.
  enum class Kind { slot, v, u };
  Vec2 at{0, 0};       // m, on an edge of the plate
  double depth = 0.0;  // m, > 0, from there to the tip
  double width = 0.0;  // m, > 0, across its direction; of a V where it leaves `at`
  Kind kind = Kind::slot;
  double angle = 0.0;  // rad, anticlockwise from the perpendicular of the edge; from a corner it
                       // goes along the diagonal of the two edges
};
inline constexpr std::array<std::string_view, 3> notch_names{"slot", "v", "u"};

// Its area; it begins outside of the plate, so that nothing stays between it and the edge.
Shape shape_of(const Notch& notch, const Plate& plate);

// Adds a problem when it does not begin on an edge, or a side of it would not come out there.
void check(const Plate& plate, const Notch& notch, Problems& problems);

}  // namespace hackle
