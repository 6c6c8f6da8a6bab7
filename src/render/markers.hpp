// SPDX-License-Identifier: MIT
// Points of a plate with their names.
#pragma once

#include <optional>
#include <vector>

#include "render/camera.hpp"
#include "render/canvas.hpp"
#include "render/layout.hpp"

namespace hackle {

struct PlacedMarker {
  Vec2 place{0, 0};                 // px
  std::optional<PlacedText> label;  // nothing where there is no room left for it
};

// Of those that are seen on the plate, a rectangle of the layout. A label stands right of its
// point, or on another side where it would leave the picture or cover what stands there already;
// one longer than the picture is shortened.
std::vector<PlacedMarker> place_markers(const std::vector<Marker>& markers, const Layout& layout,
                                        const Rectangle& plate, const Camera& camera,
                                        const Font& font);

void draw(Canvas& canvas, const std::vector<PlacedMarker>& markers, const Layout& layout,
          const Font& font);

}  // namespace hackle
