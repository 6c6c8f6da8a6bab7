// SPDX-License-Identifier: MIT
// Labelled points of a plate.
#pragma once

#include <optional>
#include <vector>

#include "render/camera.hpp"
#include "render/overlay/canvas.hpp"
#include "render/overlay/layout.hpp"

namespace hackle {

struct PlacedMarker {
  Vec2 place{0, 0};                 // px
  std::optional<PlacedText> label;  // empty if there is no room for it
};

// Places those markers that are visible on the plate, a rectangle of the layout. A label stands
// right of its point, or on another side if it would leave the picture or cover an earlier one; a
// label longer than the picture is shortened.
std::vector<PlacedMarker> place_markers(const std::vector<Marker>& markers, const Layout& layout,
                                        const Rectangle& plate, const Camera& camera,
                                        const Font& font);

void draw(Canvas& canvas, const std::vector<PlacedMarker>& markers, const Layout& layout,
          const Font& font);

}  // namespace hackle
