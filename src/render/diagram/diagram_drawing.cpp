// SPDX-License-Identifier: MIT
#include "render/diagram/diagram_drawing.hpp"

#include <algorithm>
#include <cmath>

namespace hackle {
namespace {

double width_of_bars(const std::vector<Vec2>& points) {
  return points.size() > 1 ? points[1].x() - points[0].x() : 1.0;
}

constexpr int intervals_of_x = 8, intervals_of_y = 5;

// Returns what the curves take up along an axis; 0 to 1 if nothing.
Ends seen_along(const Diagram& diagram, int axis) {
  const DiagramAxis& described = axis == 0 ? diagram.x : diagram.y;
  std::optional<Ends> ends;
  const auto see = [&](double value) {
    if (!std::isfinite(value) || (described.logarithmic && !(value > 0.0))) return;
    if (!ends) ends = Ends{value, value};
    ends = Ends{std::min(ends->min, value), std::max(ends->max, value)};
  };
  for (const DiagramCurve& curve : diagram.curves) {
    const bool bars = curve.stroke == DiagramStroke::bars && axis == 0;
    const double half = bars ? 0.5 * width_of_bars(curve.points) : 0.0;
    for (const Vec2& point : curve.points) {
      if (!point.allFinite()) continue;
      see(point[axis] - half);
      see(point[axis] + half);
    }
  }
  if (axis == 1)
    for (const DiagramLevel& level : diagram.levels) see(level.value);
  return ends.value_or(described.logarithmic ? Ends{1.0, 10.0} : Ends{0.0, 1.0});
}

// Keeps of the points that share a px across the lowest and the highest, so that a table of a
// million rows stays a small file. A line that goes back keeps all.
std::vector<Vec2> thinned(const std::vector<Vec2>& points) {
  std::vector<Vec2> kept;
  for (std::size_t k = 0; k < points.size();) {
    std::size_t end = k, low = k, high = k;
    while (end < points.size() && std::floor(points[end].x()) == std::floor(points[k].x())) {
      if (points[end].y() < points[low].y()) low = end;
      if (points[end].y() > points[high].y()) high = end;
      ++end;
    }
    std::vector<std::size_t> of_px{k, std::min(low, high), std::max(low, high), end - 1};
    of_px.erase(std::unique(of_px.begin(), of_px.end()), of_px.end());
    for (const std::size_t one : of_px) kept.push_back(points[one]);
    k = end;
  }
  return kept;
}

}  // namespace

DiagramDrawing::DiagramDrawing(const Diagram& diagram, const DiagramSize& size, const Theme& theme,
                               const Font& font)
    : diagram_(diagram),
      size_(size),
      theme_(theme),
      font_(font),
      small_(std::round(0.85 * size.font)),
      x_(diagram.x, seen_along(diagram, 0), intervals_of_x, diagram.to_scale),
      y_(diagram.y, seen_along(diagram, 1), intervals_of_y, true) {
  write_head();
  find_frame();
  if (diagram.to_scale) keep_to_scale();
  write_axes();
  write_levels();
  write_marks();
}

Colour DiagramDrawing::colour_of(std::size_t curve) const {
  return theme_.curves[curve % theme_.curves.size()];
}

void DiagramDrawing::add(const std::string& text, double x, double y, double anchor,
                         Colour colour) {
  texts_.push_back(font_.place(text, x, y, small_, anchor, colour));
}

void DiagramDrawing::write_marks() {
  for (std::size_t k = 0; k < diagram_.curves.size(); ++k) {
    const DiagramCurve& curve = diagram_.curves[k];
    if (curve.mark.empty() || curve.points.empty() || !holds(curve.points.back())) continue;
    const Vec2 at = place(curve.points.back());
    const bool within = at.x() >= frame_.x && at.x() <= frame_.right() && at.y() >= frame_.y &&
                        at.y() <= frame_.bottom();
    if (within) add(curve.mark, at.x() + 0.35 * small_, at.y() - 0.35 * small_, 0.0, colour_of(k));
  }
}

// The title, and below it the names of the curves in their colours, in as many rows as they need.
void DiagramDrawing::write_head() {
  const double margin = size_.font, right = size_.width - margin;
  double y = margin;
  if (!diagram_.title.empty()) {
    y += size_.font;
    texts_.push_back(font_.place(font_.fitting(diagram_.title, size_.font, right - margin), margin,
                                 y, size_.font, 0.0, theme_.text));
    y += 0.6 * size_.font;
  }
  double x = margin;
  bool any = false;
  for (std::size_t k = 0; k < diagram_.curves.size(); ++k) {
    if (diagram_.curves[k].name.empty()) continue;
    const std::string name = font_.fitting(diagram_.curves[k].name, small_, right - margin);
    const double width = font_.width_of(name, small_);
    if (!any) y += 1.2 * small_;
    if (any && x + width > right) {
      x = margin;
      y += 1.4 * small_;
    }
    any = true;
    add(name, x, y, 0.0, colour_of(k));
    x += width + 1.5 * small_;
  }
  top_ = y + (any ? 0.5 * small_ : 0.0);
}

void DiagramDrawing::find_frame() {
  double width = 0.0;
  for (const std::string& text : y_.texts()) width = std::max(width, font_.width_of(text, small_));
  const double half = x_.texts().empty() ? 0.0 : 0.5 * font_.width_of(x_.texts().back(), small_);
  const double left = size_.font + std::ceil(width + 0.6 * small_);
  const double right = size_.width - std::ceil(std::max(size_.font, half + 0.3 * small_));
  const double top = top_ + std::ceil(1.8 * small_);
  const double bottom = size_.height - std::ceil(3.6 * small_);
  const auto px = [](double length) { return static_cast<int>(std::lround(length)); };
  frame_ = {px(left), px(top), std::max(1, px(right - left)), std::max(1, px(bottom - top))};
}

// Makes the frame smaller along one axis, in its middle.
void DiagramDrawing::keep_to_scale() {
  const double along_x = x_.ends().max - x_.ends().min, along_y = y_.ends().max - y_.ends().min;
  const double px = std::min(frame_.width / along_x, frame_.height / along_y);
  const int width = std::max(1, static_cast<int>(std::lround(px * along_x)));
  const int height = std::max(1, static_cast<int>(std::lround(px * along_y)));
  frame_.y += (frame_.height - height) / 2;
  frame_.width = width;
  frame_.height = height;
}

void DiagramDrawing::write_axes() {
  add(font_.fitting(y_.heading(), small_, 0.9 * size_.width), size_.font, frame_.y - 0.9 * small_,
      0.0, theme_.text);
  for (std::size_t k = 0; k < y_.ticks().size(); ++k)
    add(y_.texts()[k], frame_.x - 0.6 * small_,
        frame_.bottom() - y_.share(y_.ticks()[k]) * frame_.height + 0.35 * small_, 1.0,
        theme_.quiet);
  double reached = -1e9;
  for (std::size_t k = 0; k < x_.ticks().size(); ++k) {
    const double x = frame_.x + x_.share(x_.ticks()[k]) * frame_.width;
    const double half = 0.5 * font_.width_of(x_.texts()[k], small_);
    if (x - half < reached + 0.5 * small_) continue;
    reached = x + half;
    add(x_.texts()[k], x, frame_.bottom() + 1.4 * small_, 0.5, theme_.quiet);
  }
  add(font_.fitting(x_.heading(), small_, 0.9 * size_.width), frame_.right(),
      frame_.bottom() + 2.9 * small_, 1.0, theme_.text);
}

void DiagramDrawing::write_levels() {
  for (const DiagramLevel& level : diagram_.levels)
    if (y_.holds(level.value) && y_.share(level.value) >= 0.0 && y_.share(level.value) <= 1.0)
      add(level.name, frame_.right() - 0.4 * small_,
          frame_.bottom() - y_.share(level.value) * frame_.height - 0.4 * small_, 1.0,
          theme_.quiet);
}

Vec2 DiagramDrawing::place(const Vec2& point) const {
  return {frame_.x + x_.share(point.x()) * frame_.width,
          frame_.bottom() - y_.share(point.y()) * frame_.height};
}

void DiagramDrawing::draw_grid(Canvas& canvas) const {
  const int hairline = std::max(1, static_cast<int>(std::lround(0.05 * size_.font)));
  const double before = 0.5 * hairline;  // centres lines on their values
  constexpr double faint = 0.35;
  canvas.colour(theme_.outline, faint);
  for (const double value : y_.ticks())
    canvas.fill(frame_.x, std::round(frame_.bottom() - y_.share(value) * frame_.height - before),
                frame_.width, hairline);
  for (const double value : x_.ticks())
    canvas.fill(std::round(frame_.x + x_.share(value) * frame_.width - before), frame_.y, hairline,
                frame_.height);
  canvas.colour(theme_.outline);
  canvas.outline(frame_, hairline);
  canvas.colour(theme_.quiet);
  for (const DiagramLevel& level : diagram_.levels)
    if (y_.holds(level.value))
      canvas.fill(frame_.x,
                  std::round(frame_.bottom() - y_.share(level.value) * frame_.height - before),
                  frame_.width, 2 * hairline);
}

// A few points are marked, too.
void DiagramDrawing::draw_line(Canvas& canvas, const DiagramCurve& curve) const {
  const double width = std::max(1.5, 0.11 * size_.font);
  constexpr std::size_t few = 30;
  if (curve.points.size() <= few) draw_dots(canvas, curve);
  std::vector<Vec2> piece;
  const auto end_piece = [&] {
    if (piece.size() == 1) canvas.dot(piece.front(), width);
    if (piece.size() > 1) canvas.line(thinned(piece), width);
    piece.clear();
  };
  for (const Vec2& point : curve.points)
    if (holds(point))
      piece.push_back(place(point));
    else
      end_piece();
  end_piece();
}

void DiagramDrawing::draw_bars(Canvas& canvas, const DiagramCurve& curve) const {
  const double half = 0.45 * width_of_bars(curve.points);
  for (const Vec2& point : curve.points) {
    if (!holds(point) || point.y() == 0.0) continue;
    const Vec2 top = place({point.x() - half, point.y()});
    const double right = place({point.x() + half, point.y()}).x();
    canvas.fill(top.x(), top.y(), right - top.x(), frame_.bottom() - top.y());
  }
}

void DiagramDrawing::draw_dots(Canvas& canvas, const DiagramCurve& curve) const {
  for (const Vec2& point : curve.points)
    if (holds(point)) canvas.dot(place(point), 0.2 * size_.font);
}

void DiagramDrawing::draw_curve(Canvas& canvas, const DiagramCurve& curve) const {
  if (curve.stroke == DiagramStroke::line) draw_line(canvas, curve);
  if (curve.stroke == DiagramStroke::bars) draw_bars(canvas, curve);
  if (curve.stroke == DiagramStroke::dots) draw_dots(canvas, curve);
}

void DiagramDrawing::draw(Canvas& canvas) const {
  canvas.colour(theme_.background, theme_.opacity);
  canvas.fill(0, 0, size_.width, size_.height);
  draw_grid(canvas);
  canvas.within(frame_, [&] {
    for (std::size_t k = 0; k < diagram_.curves.size(); ++k) {
      canvas.colour(colour_of(k));
      draw_curve(canvas, diagram_.curves[k]);
    }
  });
  for (const PlacedText& text : texts_) canvas.write(font_, text);
}

}  // namespace hackle
