// SPDX-License-Identifier: MIT
// Draws a diagram.
#pragma once

#include <vector>

#include "render/diagram/diagram.hpp"
#include "render/diagram/scaled_axis.hpp"
#include "render/overlay/canvas.hpp"
#include "render/overlay/rectangle.hpp"
#include "render/theme.hpp"

namespace hackle {

// The size of a diagram and its texts, px.
struct DiagramSize {
  int width = 1280, height = 800;
  double font = 22.0;
};

class DiagramDrawing {
 public:
  // Everything must outlive the drawing.
  DiagramDrawing(const Diagram& diagram, const DiagramSize& size, const Theme& theme,
                 const Font& font);

  void draw(Canvas& canvas) const;
  // Returns title, names of curves, headings and numbers of the axes, names of levels.
  const std::vector<PlacedText>& texts() const { return texts_; }
  const Rectangle& frame() const { return frame_; }

 private:
  void write_head();
  void find_frame();
  void keep_to_scale();
  void write_axes();
  void write_levels();
  void write_marks();
  void add(const std::string& text, double x, double y, double anchor, Colour colour);
  Colour colour_of(std::size_t curve) const;
  Vec2 place(const Vec2& point) const;
  bool holds(const Vec2& point) const { return x_.holds(point.x()) && y_.holds(point.y()); }
  void draw_grid(Canvas& canvas) const;
  void draw_curve(Canvas& canvas, const DiagramCurve& curve) const;
  void draw_line(Canvas& canvas, const DiagramCurve& curve) const;
  void draw_dots(Canvas& canvas, const DiagramCurve& curve) const;
  void draw_bars(Canvas& canvas, const DiagramCurve& curve) const;

  const Diagram& diagram_;
  const DiagramSize size_;
  const Theme& theme_;
  const Font& font_;
  double small_ = 0.0;  // px, size of numbers
  double top_ = 0.0;    // px, below title and names
  ScaledAxis x_, y_;
  Rectangle frame_;
  std::vector<PlacedText> texts_;
};

}  // namespace hackle
