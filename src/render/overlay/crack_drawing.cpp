// SPDX-License-Identifier: MIT
#include "render/overlay/crack_drawing.hpp"

#include <algorithm>
#include <utility>

namespace hackle {
namespace {

constexpr Colour path_rim{0, 0, 0}, path_ink{90, 230, 240};  // seen on any colour of a field

std::vector<Vec2> in_pixels(const std::vector<Vec2>& path, const Camera& camera) {
  std::vector<Vec2> points(path.size());
  std::ranges::transform(path, points.begin(),
                         [&](const Vec2& place) { return camera.pixel(place); });
  return points;
}

}  // namespace

void draw(Canvas& canvas, const CrackDrawing& cracks, const Layout& layout, const Rectangle& plate,
          const Camera& camera) {
  const double width = std::max(1.5, 0.1 * layout.small_font);
  canvas.within(plate, [&] {
    for (const auto& [colour, extra] : {std::pair{path_rim, 1.5}, {path_ink, 0.0}}) {
      canvas.colour(colour);
      for (const std::vector<Vec2>& path : cracks.paths)
        if (path.size() > 1) canvas.line(in_pixels(path, camera), width + extra);
    }
  });
}

}  // namespace hackle
