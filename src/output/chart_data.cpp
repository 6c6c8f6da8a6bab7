// SPDX-License-Identifier: MIT
#include "output/chart_data.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "measure/energy.hpp"

namespace hackle {
namespace {

struct LoadCourse {
  std::string kind;              // "traction"
  std::string place;             // "top", to tell it from others of its kind; may be empty
  std::optional<double> stress;  // Pa, when the factor is 1
  const Course* course = nullptr;
};

std::vector<LoadCourse> courses_of(const Loads& loads) {
  std::vector<LoadCourse> all;
  for (const Traction& one : loads.tractions) {
    std::optional<double> stress;
    if (one.stress.is_constant()) stress = one.stress.constant().norm();
    all.push_back({"traction", std::string(name_of(one.edge)), stress, &one.course});
  }
  for (const Pressure& one : loads.pressures)
    all.push_back({"pressure", one.rim, one.pressure, &one.course});
  for (const BodyForce& one : loads.body_forces) all.push_back({"body force", "", {}, &one.course});
  for (const Support& one : loads.supports) {
    // What is held still acts with any factor alike.
    if (!one.value.is_constant() || one.value.constant().norm() > 0.0)
      all.push_back({"support", "", {}, &one.course});
  }
  for (const Heating& one : loads.heatings) all.push_back({"heating", "", {}, &one.course});
  return all;
}

// From t = 0 to `until`; the present value of a function.
std::vector<Vec2> points_of(const Course& course, double size, double now, double until) {
  if (course.is_function()) return {{now, size * course.at(now)}};
  std::vector<Vec2> points{{0.0, size * course.at(0.0)}};
  for (const Vec2& point : course.points())
    if (point.x() > 0.0 && point.x() < until) points.emplace_back(point.x(), size * point.y());
  points.emplace_back(until, size * course.at(until));
  return points;
}

double last_moment(const std::vector<LoadCourse>& courses) {
  double last = 0.0;
  for (const LoadCourse& one : courses)
    for (const Vec2& point : one.course->points()) last = std::max(last, point.x());
  return last;
}

// Tells loads apart that have the same kind and place.
void number_places(std::vector<LoadCourse>& loads) {
  for (std::size_t k = 0; k < loads.size(); ++k) {
    int number = 1;
    for (std::size_t other = k + 1; other < loads.size(); ++other) {
      if (loads[other].kind != loads[k].kind || loads[other].place != loads[k].place) continue;
      loads[other].place += fmt::format("{}{}", loads[k].place.empty() ? "" : " ", ++number);
    }
  }
}

}  // namespace

Chart load_curve(const Simulation& simulation) {
  std::vector<LoadCourse> courses = courses_of(simulation.plate().loads);
  number_places(courses);
  const double now = simulation.time();
  Chart chart;
  const bool stresses =
      std::ranges::all_of(courses, [](const LoadCourse& one) { return one.stress.has_value(); });
  chart.heading = courses.empty() ? "no loads" : stresses ? "load" : "load factor";
  if (stresses && !courses.empty()) chart.unit = "Pa";
  chart.until = std::max(simulation.end_time(), now);
  if (chart.until == 0.0) chart.until = 1.25 * last_moment(courses);
  if (chart.until == 0.0) chart.until = 100.0 * simulation.dt();
  for (const LoadCourse& one : courses)
    chart.curves.push_back(
        {one.kind, one.place,
         points_of(*one.course, stresses ? *one.stress : 1.0, now, chart.until)});
  return chart;
}

Chart energy_chart(const Simulation& simulation) {
  const Energy now = energy(simulation);
  const double time = simulation.time();
  Chart chart{"energy",
              "J/m",
              std::max(simulation.end_time(), time),
              {{"kinetic", "", {{time, now.kinetic}}},
               {"strain", "", {{time, now.strain}}},
               {"broken", "", {{time, now.broken}}}}};
  if (now.released != 0.0) chart.curves.push_back({"released", "", {{time, now.released}}});
  return chart;
}

void check_alone(const char* output, const PictureOptions& options) {
  if (!options.overlay.energy) return;
  throw Error(
      ErrorKind::refused,
      fmt::format("{}: energy shows what was so far, a picture alone knows its own moment", output),
      "ask for it in s:movie, or read s:report()");
}

void check_recorded(const char* output, const PictureOptions& options) {
  if (!options.overlay.load_curve) return;
  throw Error(ErrorKind::refused, fmt::format("{}: a recording does not hold the loads", output),
              "ask for load_curve while the plate is solved, in s:movie or s:frame");
}

}  // namespace hackle
