// SPDX-License-Identifier: MIT
#include "render/overlay/chart.hpp"

#include <algorithm>

namespace hackle {
namespace {

const Curve* find(const Chart& chart, const Curve& like) {
  const auto found = std::ranges::find_if(chart.curves, [&](const Curve& curve) {
    return curve.kind == like.kind && curve.place == like.place;
  });
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

std::vector<NamedCurve> distinct(const std::vector<Curve>& curves) {
  std::vector<const Curve*> kept;
  for (const Curve& curve : curves)
    if (std::ranges::none_of(kept, [&](const Curve* other) {
          return other->kind == curve.kind && other->points == curve.points;
        }))
      kept.push_back(&curve);
  std::vector<NamedCurve> named;
  for (const Curve* curve : kept) {
    const bool alone = std::ranges::count(kept, curve->kind, &Curve::kind) == 1;
    const bool plain = alone || curve->place.empty();
    named.push_back({plain ? curve->kind : curve->kind + " " + curve->place, curve->points});
  }
  return named;
}

std::vector<Vec2> ChartHistory::went_on(const Curve& curve) const {
  const Curve* before = find(all_, curve);
  const Curve* foreseen = find(fresh_, curve);
  if (before == nullptr || foreseen == nullptr || before->points.empty() || curve.points.empty())
    return curve.points;
  const bool course = curve.points.size() > 1;
  if (course && curve.points == foreseen->points) return before->points;
  std::vector<Vec2> all;
  for (const Vec2& point : before->points)
    if (point.x() <= last_) all.push_back(point);
  if (course) all.emplace_back(last_, value_at(before->points, last_));
  if (course) all.emplace_back(last_, value_at(curve.points, last_));
  for (const Vec2& point : curve.points)
    if (point.x() > last_) all.push_back(point);
  return all;
}

const Chart& ChartHistory::add(const Chart& fresh, double time) {
  const bool goes_on = time > last_ && fresh.unit == fresh_.unit;
  Chart all = fresh;
  if (goes_on) {
    all.until = std::max(fresh.until, all_.until);
    for (Curve& curve : all.curves) curve.points = went_on(curve);
  }
  all_ = std::move(all);
  fresh_ = fresh;
  last_ = time;
  return all_;
}

}  // namespace hackle
