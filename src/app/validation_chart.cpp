// SPDX-License-Identifier: MIT
#include "app/validation_chart.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/markup.hpp"
#include "base/units.hpp"
#include "render/overlay/ticks.hpp"

namespace hackle {
namespace {

// Of a chart, px.
constexpr double width = 420, height = 240, left = 64, right = 14, top = 26, bottom = 40;
constexpr double bar_width = 90, bar_height = 14;

// Numbers along an axis, and where they are.
struct Axis {
  double min = 0.0, max = 1.0;
  double from = 0.0, to = 1.0;  // px

  double px(double value) const { return from + (value - min) / (max - min) * (to - from); }
};

std::vector<double> finite(std::span<const double> one, std::span<const double> other) {
  std::vector<double> values;
  for (const auto& list : {one, other})
    std::ranges::copy_if(list, std::back_inserter(values),
                         [](double v) { return std::isfinite(v); });
  return values;
}

// The axis holds all finite values of both, with a margin.
Axis axis_of(std::span<const double> one, std::span<const double> other, double from, double to) {
  const std::vector<double> values = finite(one, other);
  if (values.empty()) return {.from = from, .to = to};
  const auto [least, most] = std::ranges::minmax(values);
  const double range = most > least ? most - least : std::max(1.0, std::abs(most));
  return {.min = least - 0.04 * range, .max = least + 1.04 * range, .from = from, .to = to};
}

template <class Draw>
void for_each_tick(const Axis& axis, double unit, const Draw& draw) {
  const std::vector<double> values = neat_values(axis.min / unit, axis.max / unit, 5);
  const std::vector<std::string> texts = tick_texts(values);
  for (std::size_t k = 0; k < values.size(); ++k) draw(axis.px(values[k] * unit), texts[k]);
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
  for_each_tick(x, 1.0, [&](double at, const std::string& text) {
    svg += grid_line(at, y.from, at, y.to) + label(at, y.from + 15, "middle", text);
  });
  for_each_tick(y, unit, [&](double at, const std::string& text) {
    svg += grid_line(x.from, at, x.to, at) + label(x.from - 6, at + 4, "end", text);
  });
  return svg;
}

std::string polyline_of(const ExpectedCurve& curve, const Axis& x, const Axis& y) {
  std::string points;
  for (std::size_t k = 0; k < curve.x.size(); ++k)
    if (std::isfinite(curve.expected[k]))
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
  const PrefixedUnit unit = axis_unit(std::max(std::abs(y.min), std::abs(y.max)), e.unit);
  const std::string head =
      e.unit.empty() ? e.quantity : fmt::format("{} in {}", e.quantity, unit.name);
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
