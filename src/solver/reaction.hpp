// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "scene/vec2.hpp"

namespace hackle {

// The force of the plate on what holds, leads or meets it: a rigid body, a support, a foundation
// (src/solver/README.md 3.10).
struct Reaction {
  std::string name;      // as given, or "roller1"
  std::string_view who;  // "roller"
  int number = 1;        // of its kind, from 1
  Vec2 centre{0, 0};     // m, of the body, or the mean of the places of its nodes, now
  Vec2 force{0, 0};      // N per m of thickness
  double moment = 0.0;   // N m per m, of the forces on all nodes, where they are now, about the
                         // lower left corner of the plate; anticlockwise
  Vec2 moved{0, 0};      // m, way of the body, or the mean displacement of its nodes, so far
};

}  // namespace hackle
