// SPDX-License-Identifier: MIT
#include "render/overlay/axes.hpp"

#include <algorithm>
#include <cmath>

#include "render/overlay/ticks.hpp"

namespace hackle {
namespace {

constexpr double millimetre = 1e-3;

// Returns as many intervals as leave `room` px for each number.
int intervals_for(double length, double room) {
  return std::clamp(static_cast<int>(length / room), 1, 10);
}

}  // namespace

Axes::Axes(const Rectangle& plate, const Camera& camera, const Layout& layout, const Theme& theme,
           const Font& font)
    : plate_(plate),
      size_(layout.small_font),
      mark_(axis_mark(layout.small_font)),
      hairline_(layout.hairline),
      colour_(theme.quiet) {
  place_across(camera, font);
  place_upwards(camera, font);
}

void Axes::place_across(const Camera& camera, const Font& font) {
  constexpr double wide = 5.0;  // of a number with its distance, in units of the size
  const double left = camera.place({plate_.x, plate_.y}).x() / millimetre;
  const double right = camera.place({plate_.right(), plate_.y}).x() / millimetre;
  const std::vector<double> values =
      neat_values(left, right, intervals_for(plate_.width, wide * size_));
  std::vector<std::string> texts = tick_texts(values);
  if (!texts.empty()) texts.back() += " mm";
  const double base = plate_.bottom() + mark_ + 1.1 * size_;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double x = plate_.x + (values[k] - left) / (right - left) * plate_.width;
    across_.push_back(x);
    // A number may reach beyond the plate by half the room that the layout keeps beside it.
    const double half = 0.5 * font.width_of(texts[k], size_);
    const double middle = std::min(x, plate_.right() + size_ - half);
    texts_.push_back(font.place(texts[k], middle, base, size_, 0.5, colour_));
  }
}

void Axes::place_upwards(const Camera& camera, const Font& font) {
  constexpr double high = 2.0;  // of a number with its distance, in units of the size
  const double top = camera.place({plate_.x, plate_.y}).y() / millimetre;
  const double bottom = camera.place({plate_.x, plate_.bottom()}).y() / millimetre;
  const std::vector<double> values =
      neat_values(bottom, top, std::min(5, intervals_for(plate_.height, high * size_)));
  const std::vector<std::string> texts = tick_texts(values);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double y = plate_.bottom() - (values[k] - bottom) / (top - bottom) * plate_.height;
    upwards_.push_back(y);
    texts_.push_back(font.place(texts[k], plate_.x - mark_ - 0.3 * size_, y + 0.35 * size_, size_,
                                1.0, colour_));
  }
}

void Axes::draw(Canvas& canvas) const {
  const double before = 0.5 * hairline_;  // centres marks on their values
  canvas.colour(colour_);
  for (const double x : across_)
    canvas.fill(std::round(x - before), plate_.bottom(), hairline_, mark_);
  for (const double y : upwards_)
    canvas.fill(plate_.x - mark_, std::round(y - before), mark_, hairline_);
}

}  // namespace hackle
