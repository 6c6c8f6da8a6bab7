// SPDX-License-Identifier: MIT
// Paths of cracks and their tips over a plate.
#pragma once

#include <vector>

#include "render/camera.hpp"
#include "render/overlay/canvas.hpp"
#include "render/overlay/layout.hpp"
#include "render/overlay/overlay_text.hpp"

namespace hackle {

struct CrackDrawing {
  std::vector<std::vector<Vec2>> paths;  // m
  std::vector<Marker> tips;              // drawn like the markers of the user
};

// Draws the paths inside the plate, a rectangle of the layout.
void draw(Canvas& canvas, const CrackDrawing& cracks, const Layout& layout, const Rectangle& plate,
          const Camera& camera);

}  // namespace hackle
