// SPDX-License-Identifier: MIT
#include "render/overlay/scale_bar.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {
namespace {

std::string length_text(double length) {
  const PrefixedUnit unit = prefixed(length, "m");
  return fmt::format("{:.4g} {}", length / unit.factor, printed_unit(unit.name));
}

}  // namespace

ScaleBar::ScaleBar(const Layout& layout, const OverlayText& text, const Font& font,
                   double metres_per_pixel)
    : right_(layout.scale.right()),
      y_(layout.scale.y + 0.5 * std::round(0.8 * layout.font)),
      thickness_(std::max(2.0, std::round(0.14 * layout.font))),
      serif_(std::round(0.35 * layout.font)) {
  constexpr double share = 0.2, min = 4.0;  // of the plate, and in units of the font
  const double wanted = std::max(share * layout.plate.width, min * layout.font);
  const double max = std::min<double>(layout.scale.width, wanted);
  const double length = neat_at_most(max * metres_per_pixel);
  left_ = right_ - length / metres_per_pixel;
  const std::string name = font.fitting(length_text(length), layout.small_font, layout.scale.width);
  const double half = 0.5 * font.width_of(name, layout.small_font);
  const double middle = std::min(0.5 * (left_ + right_), right_ - half);
  // The base line of the colour bar's numbers: one line below the colours.
  const double base =
      layout.scale.y + std::round(0.8 * layout.font) + 0.4 * layout.font + 0.85 * layout.small_font;
  text_ = font.place(name, middle, base, layout.small_font, 0.5, theme_of(text.background).text);
}

void ScaleBar::draw(Canvas& canvas) const {
  const double post = std::max(1.0, std::floor(0.5 * thickness_));
  canvas.colour(text_.colour);
  canvas.fill(left_, y_ - 0.5 * thickness_, right_ - left_, thickness_);
  canvas.fill(left_, y_ - serif_, post, 2.0 * serif_);
  canvas.fill(right_ - post, y_ - serif_, post, 2.0 * serif_);
}

}  // namespace hackle
