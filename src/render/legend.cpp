// SPDX-License-Identifier: MIT
#include "render/legend.hpp"

#include <cstring>

#include "render/style_text.hpp"

namespace hackle {
namespace {

// A plate that is flat, since nothing of it is seen.
const Grid unseen{1000, 1, 1.0, {0.0, 0.0}};

OverlayText legend_text(const PictureStyle& style) {
  OverlayText text = overlay_text_of(style);
  text.title = text.note = "";
  text.slow_motion = 0.0;
  text.parts.clock = text.parts.load_curve = text.parts.energy = text.parts.axes = false;
  text.parts.markers.clear();
  return text;
}

Image rows_below(const Image& image, int first) {
  Image rows(image.width, image.height - first);
  std::memcpy(
      rows.pixels.data(),
      &image.pixels[static_cast<std::size_t>(first) * static_cast<std::size_t>(image.stride())],
      rows.pixels.size());
  return rows;
}

}  // namespace

Legend::Legend(const PictureStyle& style, int width, double pixels_a_metre)
    : layout_(make_layout(unseen, width, legend_text(style))),
      overlay_(layout_, legend_text(style), colour_maps_of(style), pixels_a_metre) {
}

Image Legend::paint(const std::vector<Beyond>& beyond) {
  if (layout_.bars.empty() && layout_.scale.empty()) return {layout_.width, 0};
  Image image(layout_.width, layout_.height);
  const Camera camera(unseen, {0, 0, unseen.nx, unseen.ny}, 0.0, layout_.plate);
  overlay_.draw(image, {camera, camera}, {0.0, {}, {}, {}, beyond});
  return rows_below(image, layout_.foot);
}

}  // namespace hackle
