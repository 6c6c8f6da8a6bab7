// SPDX-License-Identifier: MIT
#include "render/chart.hpp"

#include <algorithm>

namespace hackle {
namespace {

const Curve* find(const Chart& chart, const std::string& name) {
  const auto found = std::ranges::find(chart.curves, name, &Curve::name);
  return found == chart.curves.end() ? nullptr : &*found;
}

}  // namespace

double value_at(const std::vector<Vec2>& points, double time) {
  const auto next =
      std::ranges::upper_bound(points, time, {}, [](const Vec2& point) { return point.x(); });
  if (next == points.begin()) return points.front().y();
  if (next == points.end()) return points.back().y();
  const Vec2 before = *std::prev(next);
  return before.y() + (time - before.x()) / (next->x() - before.x()) * (next->y() - before.y());
}

Curve ChartHistory::went_on(const Curve& curve) const {
  const Curve* before = find(all_, curve.name);
  const Curve* foreseen = find(fresh_, curve.name);
  if (before == nullptr || foreseen == nullptr || curve.points.empty()) return curve;
  const bool course = curve.points.size() > 1;
  if (course && curve.points == foreseen->points) return *before;
  Curve all{curve.name, {}};
  for (const Vec2& point : before->points)
    if (point.x() <= last_) all.points.push_back(point);
  if (course) all.points.emplace_back(last_, value_at(before->points, last_));
  if (course) all.points.emplace_back(last_, value_at(curve.points, last_));
  for (const Vec2& point : curve.points)
    if (point.x() > last_) all.points.push_back(point);
  return all;
}

const Chart& ChartHistory::add(const Chart& fresh, double time) {
  const bool goes_on = time > last_ && fresh.unit == fresh_.unit;
  Chart all = fresh;
  if (goes_on) {
    all.until = std::max(fresh.until, all_.until);
    for (Curve& curve : all.curves) curve = went_on(curve);
  }
  all_ = std::move(all);
  fresh_ = fresh;
  last_ = time;
  return all_;
}

}  // namespace hackle
