// SPDX-License-Identifier: MIT
#include "study/timed_paths.hpp"

#include <algorithm>
#include <limits>

#include "study/path_distance.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

Vec2 place_of_point(const Json& point) {
  return {point[0].get<double>(), point[1].get<double>()};
}

std::vector<TimedPoint> timed_line(const Json& crack) {
  std::vector<TimedPoint> line;
  const Json& points = crack["points_m"];
  const Json& times = crack["times_s"];
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool known = k < times.size() && times[k].is_number();
    line.push_back({place_of_point(points[k]), known ? times[k].get<double>() : 0.0});
  }
  return line;
}

// From what has cracked by that time.
double distance_from(const TimedPaths& paths, const Vec2& point, double time) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& line : paths.initial)
    for (std::size_t k = 0; k < line.size(); ++k)
      nearest = std::min(
          nearest, distance_to_segment(point, line[k], line[std::min(k + 1, line.size() - 1)]));
  for (const auto& line : paths.grown)
    for (std::size_t k = 0; k < line.size() && line[k].time <= time; ++k) {
      const bool goes_on = k + 1 < line.size() && line[k + 1].time <= time;
      nearest = std::min(
          nearest, distance_to_segment(point, line[k].place, line[goes_on ? k + 1 : k].place));
    }
  return nearest;
}

// The first point of one that is far from the other, before `best`.
void find_parting(const TimedPaths& one, const TimedPaths& other, const Nearness& near,
                  std::optional<TimedPoint>& best) {
  const double lag = near.lag(other);
  for (const auto& line : one.grown)
    for (const TimedPoint& point : line) {
      if (best && point.time >= best->time) break;
      if (distance_from(other, point.place, point.time + lag) > near.within) best = point;
    }
}

double farthest_at(double time, const TimedPaths& one, const TimedPaths& other, double lag) {
  double farthest = 0.0;
  for (const auto& line : one.grown)
    for (const TimedPoint& point : line) {
      if (point.time > time) break;
      farthest = std::max(farthest, distance_from(other, point.place, time + lag));
    }
  return farthest;
}

}  // namespace

TimedPaths timed_paths_of(const Outcome& outcome) {
  TimedPaths paths;
  if (!outcome.finished() || !outcome.told.contains("graph")) return paths;
  const Json& graph = outcome.told["graph"];
  paths.rayleigh = graph.value("c_R_m_per_s", 0.0);
  for (const Json& crack : graph["cracks"]) {
    if (crack["points_m"].empty()) continue;
    if (!crack["initial"].get<bool>()) {
      paths.grown.push_back(timed_line(crack));
      continue;
    }
    auto& line = paths.initial.emplace_back();
    for (const Json& point : crack["points_m"]) line.push_back(place_of_point(point));
  }
  return paths;
}

std::optional<TimedPoint> parting(const TimedPaths& one, const TimedPaths& other,
                                  const Nearness& near) {
  std::optional<TimedPoint> first;
  find_parting(one, other, near, first);
  find_parting(other, one, near, first);
  return first;
}

double distance_at(double time, const TimedPaths& one, const TimedPaths& other,
                   const Nearness& near) {
  return std::max(farthest_at(time, one, other, near.lag(other)),
                  farthest_at(time, other, one, near.lag(one)));
}

}  // namespace hackle
