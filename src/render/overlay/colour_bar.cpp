// SPDX-License-Identifier: MIT
#include "render/overlay/colour_bar.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "render/overlay/ticks.hpp"

namespace hackle {
namespace {

double share_of(double value, const BarText& text) {
  if (text.logarithmic) return std::log(value / text.min) / std::log(text.max / text.min);
  // Halving avoids an overflow of the difference.
  return (0.5 * value - 0.5 * text.min) / (0.5 * text.max - 0.5 * text.min);
}

std::vector<double> values_at(const BarText& text, int intervals) {
  if (text.logarithmic) return decades(text.min, text.max, intervals);
  if (text.whole) return whole_values(text.min, text.max, intervals);
  return neat_values(text.min, text.max, intervals);
}

// Positions and size of the numbers, px.
struct Numbers {
  const Rectangle& bar;
  const Rectangle& room;
  double base, size;
  Colour colour;
};

struct Ticks {
  std::vector<int> marks;
  std::vector<PlacedText> numbers;
};

// Places a number inside the room for numbers.
PlacedText number(const Numbers& all, const Font& font, const std::string& text, int x) {
  const double half = 0.5 * font.width_of(text, all.size);
  const double min = all.room.x + half, max = all.room.right() - half;
  const double middle = min < max ? std::clamp<double>(x, min, max) : 0.5 * (min + max);
  return font.place(text, middle, all.base, all.size, 0.5, all.colour);
}

Ticks ticks(const Numbers& numbers, const BarText& text, const Font& font, int intervals) {
  const std::vector<double> values = values_at(text, intervals);
  const std::vector<std::string> texts = tick_texts(values);
  Ticks all;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double share = std::clamp(share_of(values[k], text), 0.0, 1.0);
    all.marks.push_back(numbers.bar.x +
                        static_cast<int>(std::lround(share * (numbers.bar.width - 1))));
    all.numbers.push_back(number(numbers, font, texts[k], all.marks.back()));
  }
  return all;
}

bool touch(const Font& font, const PlacedText& left, const PlacedText& right) {
  constexpr double gap = 0.5;  // in units of the size
  return left.x + font.width_of(left.text, left.size) + gap * left.size > right.x;
}

bool any_touch(const Font& font, const std::vector<PlacedText>& numbers) {
  return std::ranges::adjacent_find(numbers, [&](const PlacedText& a, const PlacedText& b) {
           return touch(font, a, b);
         }) != numbers.end();
}

// Returns as many ticks as fit; one if not even two fit.
Ticks fitting_ticks(const Numbers& numbers, const BarText& text, const Font& font) {
  constexpr int linear = 5, logarithmic = 12;  // intervals
  Ticks all;
  for (int intervals = text.logarithmic ? logarithmic : linear; intervals > 0; --intervals) {
    all = ticks(numbers, text, font, intervals);
    if (!any_touch(font, all.numbers)) return all;
  }
  all.numbers.erase(all.numbers.begin(), all.numbers.end() - 1);
  return all;
}

}  // namespace

ColourBar::ColourBar(const Layout& layout, const BarRoom& room, const BarText& text,
                     const Theme& theme, const Font& font)
    : bar_(room.colours),
      mark_(static_cast<int>(std::lround(0.25 * layout.font))),
      hairline_(layout.hairline),
      colour_(theme.quiet) {
  const double below = 0.4 * layout.font + 0.85 * layout.small_font;
  Ticks all = fitting_ticks(
      {room.colours, room.ticks, room.colours.bottom() + below, layout.small_font, theme.quiet},
      text, font);
  marks_ = std::move(all.marks);
  texts_ = std::move(all.numbers);
  const double base = room.label.y + std::round(0.8 * layout.font);
  texts_.push_back(font.place(font.fitting(text.label, layout.font, room.label.width), room.label.x,
                              base, layout.font, 0.0, theme.text));
  if (text.remark.empty()) return;
  texts_.push_back(font.place(font.fitting(text.remark, layout.small_font, room.label.width),
                              room.label.x, room.colours.bottom() + below, layout.small_font, 0.0,
                              theme.quiet));
}

void ColourBar::draw(Canvas& canvas, const ColourMap& map) const {
  const std::size_t last = map.colours.size() - 1;
  const std::size_t pixels = std::max<std::size_t>(2, static_cast<std::size_t>(bar_.width)) - 1;
  // Each colour reaches to the end, under the next ones: so there is no seam where px are not
  // whole.
  for (int x = 0; x < bar_.width; ++x) {
    canvas.colour(map.colours[static_cast<std::size_t>(x) * last / pixels]);
    canvas.fill(bar_.x + x, bar_.y, bar_.width - x, bar_.height);
  }
  const int left = (hairline_ - 1) / 2;
  canvas.colour(colour_);
  for (const int mark : marks_) canvas.fill(mark - left, bar_.bottom(), hairline_, mark_);
}

void ColourBar::draw_ends(Canvas& canvas, const ColourMap& map, const Beyond& beyond) const {
  if (beyond.below) draw_end(canvas, map.colours.front(), bar_.x, -1);
  if (beyond.above) draw_end(canvas, map.colours.back(), bar_.right(), 1);
}

// The rim makes it seen where the colour is that of the ground.
void ColourBar::draw_end(Canvas& canvas, Colour colour, int from, int towards) const {
  const double tip = from + towards * 0.7 * bar_.height;
  const std::array<Vec2, 3> corners{Vec2(from, bar_.y), Vec2(tip, bar_.y + 0.5 * bar_.height),
                                    Vec2(from, bar_.bottom())};
  canvas.colour(colour);
  canvas.fill(corners);
  canvas.colour(colour_);
  canvas.line(corners, hairline_);
}

}  // namespace hackle
