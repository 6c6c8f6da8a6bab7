// SPDX-License-Identifier: MIT
#include "measure/crack_course.hpp"

#include <algorithm>
#include <cmath>

namespace hackle {
namespace {

std::size_t first_in_window(const TipCourse& course, std::size_t k, double window) {
  std::size_t first = k;
  while (first > 0 && course.ways[k] - course.ways[first - 1] <= window) --first;
  return first;
}

}  // namespace

std::optional<double> speed_at(const TipCourse& course, std::size_t k, double window) {
  const std::size_t first = first_in_window(course, k, window);
  const auto count = static_cast<double>(k - first + 1);
  double mean_way = 0.0, mean_time = 0.0;
  int moments = 0;
  for (std::size_t l = first; l <= k; ++l) {
    mean_way += course.ways[l] / count;
    mean_time += course.times[l] / count;
    moments += l == first || course.times[l] > course.times[l - 1] ? 1 : 0;
  }
  if (moments < 3) return std::nullopt;
  double both = 0.0, alone = 0.0;
  for (std::size_t l = first; l <= k; ++l) {
    const double late = course.times[l] - mean_time;
    both += late * (course.ways[l] - mean_way);
    alone += late * late;
  }
  return both / alone;
}

double speed_now(const TipCourse& course, double window, double time, double spacing) {
  if (course.size() == 0) return 0.0;
  const std::size_t end = course.size() - 1;
  const double speed = speed_at(course, end, window).value_or(0.0);
  if (!(speed > 0.0)) return 0.0;
  const double way = course.ways[end] - course.ways[first_in_window(course, end, window)];
  const double took = way / speed, waits = time - course.times[end] - spacing / speed;
  return way / (took + std::max(waits, 0.0));
}

std::optional<double> max_speed(const TipCourse& course, double window, std::size_t first) {
  std::optional<double> max;
  for (std::size_t k = first; k < course.size(); ++k) {
    if (course.ways[k] - course.ways.front() < window) continue;
    const auto speed = speed_at(course, k, window);
    if (speed) max = std::max(max.value_or(*speed), *speed);
  }
  return max;
}

}  // namespace hackle
