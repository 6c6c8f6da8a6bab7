// SPDX-License-Identifier: MIT
// Curves over time in a flat frame, marking the present.
#pragma once

#include <vector>

#include "render/overlay/canvas.hpp"
#include "render/overlay/chart.hpp"
#include "render/overlay/layout.hpp"

namespace hackle {

class StripChart {
 public:
  // Draws in `room`; the time axis goes from 0 to chart.until, or to `now` (s) if that is later.
  StripChart(const Rectangle& room, const Chart& chart, double now, const Layout& layout,
             const Theme& theme, const Font& font);

  void draw(Canvas& canvas) const;
  // Returns the heading with the unit, names of curves and numbers at the axes.
  const std::vector<PlacedText>& texts() const { return texts_; }

 private:
  struct Line {
    std::vector<Vec2> points;  // px
    Vec2 present{0, 0};        // px
    Colour colour;
  };

  void find_scale(const Chart& chart, double now);
  void write_heading(const Chart& chart);
  void write_names(double left);
  void write_values();
  void write_times();
  void place_lines(double now);
  void add(const std::string& text, double x, double y, double anchor, Colour colour);
  double px(double time) const;
  double py(double value) const;

  Rectangle room_;
  double size_;   // of all texts, px
  int hairline_;  // px
  const Theme& theme_;
  const Font& font_;
  std::vector<NamedCurve> curves_;
  double left_ = 0.0, right_ = 0.0, top_ = 0.0, bottom_ = 0.0;  // px, of the frame
  double until_ = 1.0;                                          // s
  double min_ = 0.0, max_ = 1.0;                                // values at bottom and top
  std::vector<double> values_, times_;                          // of the ticks
  std::string unit_;                                            // in the heading
  double unit_factor_ = 1.0;
  double now_ = 0.0;  // px
  std::vector<Line> lines_;
  std::vector<PlacedText> texts_;
};

}  // namespace hackle
