// SPDX-License-Identifier: MIT
#include "scene/amplitude.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {
namespace {

template <class Function>
double gauss_mean(const Function& function, double from, double to) {
  constexpr int pieces = 16;
  const double aside = 0.5 / std::numbers::sqrt3;  // from the midpoint of a subinterval
  double sum = 0.0;
  for (int k = 0; k < pieces; ++k)
    for (const double place : {k + 0.5 - aside, k + 0.5 + aside})
      sum += function(from + (to - from) * place / pieces);
  return sum / (2 * pieces);
}

}  // namespace

Amplitude::Amplitude(std::vector<Vec2> points) : points_(std::move(points)) {
}

Amplitude::Amplitude(std::function<double(double)> function, std::string text)
    : function_(std::move(function)), text_(std::move(text)) {
}

double Amplitude::at(double t) const {
  if (function_) {
    const double factor = function_(t);
    if (std::isfinite(factor)) return factor;
    throw Error(ErrorKind::refused,
                fmt::format("the amplitude in time gives {} at t = {}", factor, quantity(t, "s")),
                "it must give a finite number at every time");
  }
  if (points_.empty()) return 1.0;
  const auto next =
      std::ranges::upper_bound(points_, t, {}, [](const Vec2& point) { return point.x(); });
  if (next == points_.begin()) return next->y();
  const Vec2& before = *std::prev(next);
  if (next == points_.end()) return before.y();
  const double share = (t - before.x()) / (next->x() - before.x());
  return before.y() + share * (next->y() - before.y());
}

double Amplitude::largest() const {
  double max = is_constant() ? 1.0 : 0.0;
  for (const Vec2& point : points_) max = std::max(max, std::abs(point.y()));
  return max;
}

double Amplitude::steepest() const {
  double max = 0.0;
  for (std::size_t k = 1; k < points_.size(); ++k) {
    const Vec2 way = points_[k] - points_[k - 1];
    if (way.y() != 0.0) max = std::max(max, std::abs(way.y()) / way.x());
  }
  return max;
}

double Amplitude::mean(double from, double to) const {
  if (!(to > from)) return at(from);
  if (is_function()) return gauss_mean([this](double t) { return at(t); }, from, to);
  // The midpoint value is exact between consecutive times: the factor is linear there, and jumps
  // lie at the times.
  std::vector<double> moments{from};
  for (const Vec2& point : points_)
    if (point.x() > from && point.x() < to) moments.push_back(point.x());
  moments.push_back(to);
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < moments.size(); ++k)
    sum += (moments[k + 1] - moments[k]) * at(0.5 * (moments[k] + moments[k + 1]));
  return sum / (to - from);
}

std::string Amplitude::describe() const {
  if (is_constant()) return "constant";
  if (function_) return text_;
  std::string text;
  for (const Vec2& point : points_)
    text += fmt::format("{}{} at {}", text.empty() ? "" : ", ", shortest(point.y()),
                        quantity(point.x(), "s"));
  return text;
}

Amplitude ramp(double duration) {
  return Amplitude({{0.0, 0.0}, {duration, 1.0}});
}

Amplitude step_at(double start) {
  return Amplitude({{start, 0.0}, {start, 1.0}});
}

Amplitude pulse(double duration, double start) {
  const double end = start + duration;
  return Amplitude({{start, 0.0}, {start, 1.0}, {end, 1.0}, {end, 0.0}});
}

void check(const Amplitude& amplitude, const std::string& who, Problems& problems) {
  double last = -std::numeric_limits<double>::infinity();
  for (const Vec2& point : amplitude.points()) {
    if (!point.allFinite())
      problems.add(fmt::format("{}: the amplitude in time holds a number that is not finite", who),
                   "give finite times and factors");
    else if (point.x() < last)
      problems.add(fmt::format("{}: the amplitude in time goes back from {} to {}", who,
                               quantity(last, "s"), quantity(point.x(), "s")),
                   "give its moments in order");
    last = point.x();
  }
}

}  // namespace hackle
