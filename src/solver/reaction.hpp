// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "scene/vec2.hpp"

namespace hackle {

// The force of the plate on a rigid body, by its cells and by friction.
struct Reaction {
  std::string_view who;  // "roller"
  int number = 1;        // of its kind, from 1
  Vec2 centre{0, 0};     // m, of the body now
  Vec2 force{0, 0};      // N per m of thickness
};

}  // namespace hackle
