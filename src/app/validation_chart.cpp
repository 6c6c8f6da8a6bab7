// SPDX-License-Identifier: MIT
#include "app/validation_chart.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "base/markup.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

// Of a chart, px.
constexpr double width = 420, height = 240, left = 64, right = 14, top = 26, bottom = 40;
constexpr double bar_width = 90, bar_height = 14;

// Round numbers along an axis, and where they are.
struct Axis {
  double min = 0.0, max = 1.0, step = 1.0;
  double from = 0.0, to = 1.0;  // px

  double px(double value) const { return from + (value - min) / (max - min) * (to - from); }
};

// 1, 2 or 5 times a power of ten: about four steps.
double round_step(double range) {
  const double power = std::pow(10.0, std::floor(std::log10(range / 4.0)));
  const double share = range / 4.0 / power;
  return power * (share < 1.5 ? 1.0 : share < 3.5 ? 2.0 : share < 7.5 ? 5.0 : 10.0);
}

void widen(Axis& axis, std::span<const double> values) {
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    axis.min = std::min(axis.min, value);
    axis.max = std::max(axis.max, value);
  }
}

Axis axis_of(std::span<const double> one, std::span<const double> other, double from, double to) {
  Axis axis{.min = one.front(), .max = one.front(), .from = from, .to = to};
  widen(axis, one);
  widen(axis, other);
  if (axis.max <= axis.min) axis.max = axis.min + std::max(1.0, std::abs(axis.min));
  axis.step = round_step(axis.max - axis.min);
  const double margin = 0.04 * (axis.max - axis.min);
  axis.min -= margin;
  axis.max += margin;
  return axis;
}

template <class Draw>
void for_each_tick(const Axis& axis, const Draw& draw) {
  for (double k = std::ceil(axis.min / axis.step); k * axis.step <= axis.max; k += 1.0)
    draw(k * axis.step + 0.0);  // no -0
}

std::string label(double x, double y, std::string_view anchor, std::string_view text) {
  return fmt::format(R"(<text class="label" x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x,
                     y, anchor, xml(text));
}

std::string grid_line(double x1, double y1, double x2, double y2) {
  return fmt::format(R"(<line class="grid" x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}"/>)", x1,
                     y1, x2, y2);
}

std::string grid_of(const Axis& x, const Axis& y, double unit) {
  std::string svg;
  for_each_tick(x, [&](double value) {
    svg += grid_line(x.px(value), y.from, x.px(value), y.to) +
           label(x.px(value), y.from + 15, "middle", fmt::format("{:.4g}", value));
  });
  for_each_tick(y, [&](double value) {
    svg += grid_line(x.from, y.px(value), x.to, y.px(value)) +
           label(x.from - 6, y.px(value) + 4, "end", fmt::format("{:.4g}", value / unit));
  });
  return svg;
}

std::string polyline_of(const ExpectedCurve& curve, const Axis& x, const Axis& y) {
  std::string points;
  for (std::size_t k = 0; k < curve.x.size(); ++k)
    points += fmt::format("{:.1f},{:.1f} ", x.px(curve.x[k]), y.px(curve.expected[k]));
  return fmt::format(R"(<polyline class="line" points="{}"/>)", points);
}

std::string dots_of(const ExpectedCurve& curve, const Axis& x, const Axis& y) {
  std::string svg;
  for (std::size_t k = 0; k < curve.x.size(); ++k)
    if (std::isfinite(curve.got[k]))
      svg += fmt::format(R"(<circle class="dot" cx="{:.1f}" cy="{:.1f}" r="3.2"/>)",
                         x.px(curve.x[k]), y.px(curve.got[k]));
  return svg;
}

}  // namespace

std::string curve_chart(const Expectation& e) {
  const ExpectedCurve& curve = e.curve;
  const Axis x = axis_of(curve.x, curve.x, left, width - right);
  const Axis y = axis_of(curve.expected, curve.got, height - bottom, top);
  const PrefixedUnit unit = prefixed(std::max(std::abs(y.min), std::abs(y.max)), e.unit);
  std::string head = e.unit.empty() ? e.quantity : fmt::format("{} in {}", e.quantity, unit.name);
  return fmt::format(R"(<svg class="chart" viewBox="0 0 {:.0f} {:.0f}" role="img">)", width,
                     height) +
         grid_of(x, y, unit.factor) + polyline_of(curve, x, y) + dots_of(curve, x, y) +
         label(left, top - 12, "start", head) +
         label(0.5 * (left + width - right), height - 6, "middle", curve.along) + "</svg>";
}

std::string bounds_chart(const Expectation& e) {
  const std::optional<double> deviation = e.deviation();
  if (!deviation) return "";
  // The bounds lie at a quarter and three quarters of the bar.
  const double x = std::clamp(0.5 + 0.25 * *deviation, 0.03, 0.97) * bar_width;
  return fmt::format(
      R"(<svg class="bar" viewBox="0 0 {0:.0f} {1:.0f}" width="{0:.0f}" height="{1:.0f}" role="img">)"
      R"(<rect class="all" x="0" y="5" width="{0:.0f}" height="4" rx="2"/>)"
      R"(<rect class="good" x="{2:.1f}" y="5" width="{3:.1f}" height="4"/>)"
      R"(<circle class="{4}" cx="{5:.1f}" cy="7" r="4.5"/></svg>)",
      bar_width, bar_height, 0.25 * bar_width, 0.5 * bar_width, name_of(e.verdict()), x);
}

}  // namespace hackle
