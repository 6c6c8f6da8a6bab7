// SPDX-License-Identifier: MIT
#include "render/overlay/layout.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/overlay/font.hpp"

namespace hackle {
namespace {

int even(double value) {
  return 2 * static_cast<int>(std::ceil(value / 2.0));
}
int whole(double value) {
  return static_cast<int>(std::lround(value));
}
int raised_to(double value) {
  return static_cast<int>(std::ceil(value));
}

// Returns the pixels per cell along x and y.
double cell_size(const Grid& grid, double width, double height) {
  const double size = std::min(width / grid.nx, height / grid.ny);
  return size >= 3.0 ? std::floor(size) : size;
}

double font_for(int width) {
  return std::max(10.0, std::round(0.0175 * width));
}
int margin_for(int width) {
  return whole(1.5 * font_for(width));
}

// Two plates that are taller than wide stand side by side.
bool lies_across(const Grid& grid, const PlateSize& size) {
  return size.twice && grid.ny > grid.nx;
}

// Lays out from the top; `y_` is the height used so far.
class Composer {
 public:
  Composer(const Grid& grid, int width, const OverlayText& text, const PlateSize& size)
      : grid_(grid), text_(text), parts_(text.parts), size_(size) {
    layout_.width = width;
    layout_.font = text.font > 0.0 ? text.font : font_for(width);
    layout_.small_font = std::max(9.0, std::round(0.8 * layout_.font));
    layout_.hairline = std::max(1, whole(0.05 * layout_.font));
    margin_ = whole(1.5 * layout_.font);
    if (parts_.axes) left_of_plate_ = axis_mark(layout_.small_font) + axis_numbers();
    gap_ = raised_to(layout_.font);
  }

  Layout compose() {
    size_plate();
    place_caption();
    place_plate();
    place_legend();
    place_charts();
    layout_.height = even(y_ + 0.6 * margin_);
    return layout_;
  }

 private:
  struct Line {
    int left = 0, right = 0;  // px used on either side
  };

  // The widest number is not known yet: it has room for five letters.
  int axis_numbers() const { return needed("000.0", layout_.small_font); }
  int below_plate() const {
    return parts_.axes ? axis_mark(layout_.small_font) + raised_to(1.4 * layout_.small_font) : 0;
  }

  int room() const { return layout_.width - 2 * side_; }
  int needed(const std::string& text, double size) const {
    return raised_to(font_.width_of(text, size));
  }

  // Captions and legend are as wide as the plates, unless these are too narrow for them.
  void size_plate() {
    const int inner = layout_.width - 2 * margin_ - left_of_plate_;
    const bool across = lies_across(grid_, size_);
    const int between = gap_ + left_of_plate_;
    const int room_for_one = across ? (inner - between) / 2 : inner;
    const double cell =
        size_.cell > 0.0 ? size_.cell : cell_size(grid_, room_for_one, layout_.width);
    layout_.plate.width = std::max(1, whole(cell * grid_.nx));
    layout_.plate.height = std::max(1, whole(cell * grid_.ny));
    plates_width_ = layout_.plate.width * (across ? 2 : 1) + (across ? between : 0);
    const bool wide = plates_width_ > inner * 9 / 10;
    side_ = wide ? (layout_.width - plates_width_ - left_of_plate_) / 2 : margin_;
  }

  // Returns the first line with room, starting from that of the last text, or else a new line.
  std::size_t line_for(int width) {
    for (std::size_t k = first_line_; k < lines_.size(); ++k)
      if (lines_[k].left + width + lines_[k].right <= room()) return k;
    lines_.push_back({});
    return lines_.size() - 1;
  }

  Rectangle in_caption(const std::string& text, double size, bool left) {
    if (text.empty()) return {};
    const int width = std::min(needed(text, size), room());
    const std::size_t k = line_for(width);
    first_line_ = k;
    Line& line = lines_[k];
    const int x = left ? side_ + line.left : layout_.width - side_ - line.right - width;
    (left ? line.left : line.right) += width + gap_;
    return {x, margin_ * 2 / 3 + static_cast<int>(k) * line_height(), width, line_height()};
  }

  int line_height() const { return raised_to(1.3 * layout_.font); }

  void place_caption() {
    layout_.title = in_caption(text_.title, layout_.font, true);
    // The widest time_text, so that the title stays in place.
    if (parts_.clock) layout_.clock = in_caption("000.0000 ms", layout_.font, false);
    layout_.slow_motion =
        in_caption(slow_motion_text(text_.slow_motion), layout_.small_font, false);
    first_line_ = 0;
    layout_.note = in_caption(text_.note, layout_.small_font, true);
    const int height = static_cast<int>(lines_.size()) * line_height();
    layout_.caption = {side_, margin_ * 2 / 3, room(), height};
    y_ = lines_.empty() ? margin_ : layout_.caption.bottom() + margin_ / 3;
    if (lines_.empty()) layout_.caption.y = layout_.caption.height = 0;
  }

  void place_plate() {
    Rectangle& plate = layout_.plate;
    plate.x = (layout_.width - plates_width_ + left_of_plate_) / 2;
    plate.y = y_;
    y_ = plate.bottom() + below_plate();
    if (size_.twice) {
      layout_.second_plate = plate;
      if (lies_across(grid_, size_))
        layout_.second_plate.x = plate.right() + gap_ + left_of_plate_;
      else
        layout_.second_plate.y = plate.bottom() + below_plate() + gap_;
      y_ = layout_.second_plate.bottom() + below_plate();
    }
    layout_.foot = y_ + margin_ / 2;
  }

  int bar_height() const { return whole(0.8 * layout_.font); }
  int below_bar() const { return raised_to(0.4 * layout_.font + 1.3 * layout_.small_font); }

  void place_legend() {
    if (!parts_.bar && !parts_.scale_bar) return;
    y_ += margin_ * 5 / 6;
    int scale_x = side_, first_row = y_;
    if (parts_.bar)
      for (const BarText& bar : text_.bars) {
        layout_.bars.push_back(place_bar(bar));
        const Rectangle& colours = layout_.bars.front().colours;
        scale_x = colours.right() + 3 * margin_ / 2;
        first_row = colours.y;
      }
    const int height = bar_height() + below_bar();
    if (parts_.scale_bar)
      layout_.scale = {scale_x, first_row, layout_.width - side_ - scale_x, height};
    if (!parts_.bar) y_ += height;
  }

  // The bar and its name share a line if the scale bar still fits. All bars begin at the same x.
  BarRoom place_bar(const BarText& text) {
    constexpr double shortest = 5.0, scale = 6.0;
    BarRoom room_for;
    int label = whole(shortest * layout_.font);
    for (const BarText& bar : text_.bars) label = std::max(label, needed(bar.label, layout_.font));
    const int drop = raised_to(0.25 * layout_.font);  // descent of letters below the base line
    const int bar_width = whole(0.28 * layout_.width);
    const bool beside =
        label + gap_ + bar_width + 3 * margin_ / 2 + whole(scale * layout_.font) <= room();
    const int width = beside ? label : std::min(needed(text.label, layout_.font), room());
    room_for.label = {side_, y_, width, bar_height() + drop};
    if (!beside) y_ = room_for.label.bottom() + whole(0.3 * layout_.font);
    room_for.colours = {beside ? side_ + label + gap_ : side_, y_, bar_width, bar_height()};
    const int beyond = whole(layout_.font);
    const int top = room_for.colours.bottom() + whole(0.3 * layout_.font);
    y_ += bar_height() + below_bar();
    room_for.ticks = {room_for.colours.x - beyond, top, bar_width + 2 * beyond, y_ - top};
    return room_for;
  }

  // Places the charts side by side if both have room.
  void place_charts() {
    std::vector<Rectangle*> charts;
    if (parts_.load_curve) charts.push_back(&layout_.load_curve);
    if (parts_.energy) charts.push_back(&layout_.energy);
    if (charts.empty()) return;
    constexpr double min_width = 20.0, height = 7.5;
    const int between = 2 * gap_, count = static_cast<int>(charts.size());
    const int share = (room() - (count - 1) * between) / count;
    const int columns = share < min_width * layout_.font ? 1 : count;
    const Rectangle first{side_, y_ + margin_ * 2 / 3, (room() - (columns - 1) * between) / columns,
                          whole(height * layout_.font)};
    for (int k = 0; k < count; ++k) {
      Rectangle& chart = *charts[static_cast<std::size_t>(k)];
      chart = first;
      if (columns > 1) chart.x += k * (first.width + between);
      if (columns == 1) chart.y += k * (first.height + margin_ * 2 / 3);
      y_ = chart.bottom();
    }
  }

  const Grid& grid_;
  const OverlayText& text_;
  const OverlayOptions& parts_;
  const PlateSize& size_;
  Font font_;
  Layout layout_;
  int left_of_plate_ = 0;  // px, for axes
  int margin_ = 0, gap_ = 0, side_ = 0, plates_width_ = 0, y_ = 0;
  std::vector<Line> lines_;  // of the caption
  std::size_t first_line_ = 0;
};

}  // namespace

Grid part(const Grid& grid, const Window& window) {
  const Vec2 corner(window.left - 0.5 * grid.nx, window.bottom - 0.5 * grid.ny);
  const Vec2 middle = corner + 0.5 * Vec2(window.nx, window.ny);
  return {window.nx, window.ny, grid.dx, grid.centre + grid.dx * middle};
}

Layout make_layout(const Grid& grid, int width, const OverlayText& text, const PlateSize& size) {
  return Composer(grid, width, text, size).compose();
}

int width_for(const Grid& grid, const PlateSize& size) {
  const int plate = whole(size.cell * grid.nx);
  int width = 320;
  const auto needed = [&] {
    const int between = lies_across(grid, size) ? plate + raised_to(font_for(width)) : 0;
    return plate + between + 2 * margin_for(width);
  };
  while (needed() > width) width += std::max(2, even(0.5 * (needed() - width)));
  return width;
}

int axis_mark(double small_font) {
  return whole(0.4 * small_font);
}

Layout bare_layout(int width, int height) {
  Layout layout;
  layout.width = width;
  layout.height = height;
  layout.plate = {0, 0, width, height};
  layout.foot = height;
  return layout;
}

double neat_at_most(double max) {
  const double decade = std::pow(10.0, std::floor(std::log10(max)));
  for (const double factor : {5.0, 2.0})
    if (factor * decade <= max * (1.0 + 1e-12)) return factor * decade;
  return decade;
}

}  // namespace hackle
