// SPDX-License-Identifier: MIT
#include "render/overlay/strip_chart.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "render/overlay/ticks.hpp"

namespace hackle {
StripChart::StripChart(const Rectangle& room, const Chart& chart, double now, const Layout& layout,
                       const Theme& theme, const Font& font)
    : room_(room),
      size_(layout.small_font),
      hairline_(layout.hairline),
      theme_(theme),
      font_(font),
      curves_(distinct(chart.curves)) {
  find_scale(chart, now);
  top_ = room.y + std::round(2.0 * size_);
  bottom_ = room.bottom() - std::round(1.5 * size_);
  write_heading(chart);
  write_values();
  write_times();
  place_lines(now);
}

void StripChart::find_scale(const Chart& chart, double now) {
  constexpr int intervals = 3;
  double min = 0.0, max = 0.0;
  for (const NamedCurve& curve : curves_)
    for (const Vec2& point : curve.points) {
      min = std::min(min, point.y());
      max = std::max(max, point.y());
    }
  if (!(max > min)) max = 1.0;
  const PrefixedUnit unit = axis_unit(std::max(-min, max), chart.unit);
  unit_ = printed_unit(unit.name);
  unit_factor_ = unit.factor;
  values_ = enclosing_values(min, max, intervals);
  min_ = values_.empty() ? min : std::min(min, values_.front());
  max_ = values_.empty() ? max : std::max(max, values_.back());
  until_ = std::max(chart.until, now);
  if (!(until_ > 0.0)) until_ = 1e-6;
}

double StripChart::px(double time) const {
  return left_ + (right_ - left_) * std::clamp(time / until_, 0.0, 1.0);
}
double StripChart::py(double value) const {
  return bottom_ - (bottom_ - top_) * (value - min_) / (max_ - min_);
}

void StripChart::add(const std::string& text, double x, double y, double anchor, Colour colour) {
  texts_.push_back(font_.place(text, x, y, size_, anchor, colour));
}

void StripChart::write_heading(const Chart& chart) {
  const std::string heading =
      unit_.empty() ? chart.heading : fmt::format("{} ({})", chart.heading, unit_);
  const std::string shown = font_.fitting(heading, size_, 0.6 * room_.width);
  add(shown, room_.x, room_.y + size_, 0.0, theme_.text);
  write_names(room_.x + font_.width_of(shown, size_) + 1.5 * size_);
}

// Places names from the right, each in an equal share of the room; names without enough room are
// left out.
void StripChart::write_names(double left) {
  const double gap = std::round(size_);
  const auto count = static_cast<double>(curves_.size());
  const double share = (room_.right() - left - gap * (count - 1.0)) / count;
  double right = room_.right();
  for (std::size_t k = curves_.size(); k-- > 0;) {
    const std::string name = font_.fitting(curves_[k].name, size_, share);
    add(name, right, room_.y + size_, 1.0, theme_.curves[k % theme_.curves.size()]);
    right = texts_.back().x - gap;
  }
}

// Places values left of the frame, whose edge stays in place while the numbers grow.
void StripChart::write_values() {
  std::vector<double> shown = values_;
  for (double& value : shown) value /= unit_factor_;
  const std::vector<std::string> texts = tick_texts(shown);
  double width = font_.width_of("0000", size_);
  for (const std::string& text : texts) width = std::max(width, font_.width_of(text, size_));
  left_ = room_.x + std::ceil(width + 0.6 * size_);
  constexpr double min_distance = 1.3;  // of base lines, in units of the size
  double above = bottom_ + 2.0 * size_;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const double y = std::round(py(values_[k]));
    if (above - y < min_distance * size_) continue;
    add(texts[k], left_ - 0.6 * size_, y + 0.35 * size_, 1.0, theme_.quiet);
    above = y;
  }
}

// Places times below the frame, the last one with the unit.
void StripChart::write_times() {
  constexpr int intervals = 4;
  const PrefixedUnit unit = prefixed(until_, "s");
  const std::string name = printed_unit(unit.name);
  times_ = neat_values(0.0, until_ / unit.factor, intervals);
  std::vector<std::string> texts = tick_texts(times_);
  if (!texts.empty()) texts.back() += " " + name;
  const double half = texts.empty() ? 0.0 : 0.5 * font_.width_of(texts.back(), size_);
  right_ = room_.right() - std::ceil(half);
  const double base = bottom_ + std::round(1.25 * size_);
  for (std::size_t k = 0; k < texts.size(); ++k) {
    times_[k] *= unit.factor;
    add(texts[k], px(times_[k]), base, 0.5, theme_.quiet);
  }
}

void StripChart::place_lines(double now) {
  now_ = px(now);
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const std::vector<Vec2>& points = curves_[k].points;
    if (points.empty()) continue;
    Line line{{}, {px(now), py(value_at(points, now))}, theme_.curves[k % theme_.curves.size()]};
    for (const Vec2& point : points) line.points.emplace_back(px(point.x()), py(point.y()));
    lines_.push_back(std::move(line));
  }
}

void StripChart::draw(Canvas& canvas) const {
  constexpr double faint = 0.6;
  const double before = 0.5 * hairline_;  // centres lines on their values
  const double width = std::max(1.5, std::round(0.12 * size_));
  for (const double value : values_) {
    canvas.colour(theme_.outline, value == 0.0 ? 1.0 : faint);
    canvas.fill(left_, std::round(py(value) - before), right_ - left_, hairline_);
  }
  canvas.colour(theme_.outline);
  for (const double time : times_)
    canvas.fill(std::round(px(time) - before), bottom_, hairline_, std::round(0.3 * size_));
  canvas.colour(theme_.quiet);
  canvas.fill(std::round(now_ - before), top_, hairline_, bottom_ - top_);
  for (const Line& line : lines_) {
    canvas.colour(line.colour);
    canvas.line(line.points, width);
    canvas.dot(line.present, 1.6 * width);
  }
  for (const PlacedText& text : texts_) canvas.write(font_, text);
}

}  // namespace hackle
