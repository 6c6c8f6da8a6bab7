// SPDX-License-Identifier: MIT
#include "scene/course.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {

Course::Course(std::vector<Vec2> points) : points_(std::move(points)) {
}

Course::Course(std::function<double(double)> function, std::string text)
    : function_(std::move(function)), text_(std::move(text)) {
}

double Course::at(double t) const {
  if (function_) {
    const double factor = function_(t);
    if (std::isfinite(factor)) return factor;
    throw Error(ErrorKind::refused,
                fmt::format("the course in time gives {} at t = {}", factor, quantity(t, "s")),
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

std::string Course::describe() const {
  if (is_constant()) return "constant";
  if (function_) return text_;
  std::string text;
  for (const Vec2& point : points_)
    text += fmt::format("{}{} at {}", text.empty() ? "" : ", ", shortest(point.y()),
                        quantity(point.x(), "s"));
  return text;
}

Course ramp(double duration) {
  return Course({{0.0, 0.0}, {duration, 1.0}});
}

Course step_at(double start) {
  return Course({{start, 0.0}, {start, 1.0}});
}

Course pulse(double duration, double start) {
  const double end = start + duration;
  return Course({{start, 0.0}, {start, 1.0}, {end, 1.0}, {end, 0.0}});
}

void check(const Course& course, const std::string& who, Problems& problems) {
  double last = -std::numeric_limits<double>::infinity();
  for (const Vec2& point : course.points()) {
    if (!point.allFinite())
      problems.add(fmt::format("{}: the course in time holds a number that is not finite", who));
    else if (point.x() < last)
      problems.add(fmt::format("{}: the course in time goes back from {} to {}", who,
                               quantity(last, "s"), quantity(point.x(), "s")),
                   "give its moments in order");
    last = point.x();
  }
}

}  // namespace hackle
