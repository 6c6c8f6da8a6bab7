// SPDX-License-Identifier: MIT
#include "output/picture/chart_data.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "measure/energy.hpp"

namespace hackle {
namespace {

struct LoadAmplitude {
  std::string kind;              // "traction"
  std::string place;             // "top", to distinguish it from others of its kind; may be empty
  std::optional<double> stress;  // Pa, at amplitude 1
  const Amplitude* amplitude = nullptr;
};

std::vector<LoadAmplitude> amplitudes_of(const Loads& loads) {
  std::vector<LoadAmplitude> all;
  for (const Traction& one : loads.tractions) {
    std::optional<double> stress;
    if (one.stress.is_constant()) stress = one.stress.constant().norm();
    all.push_back(
        {"traction", one.edge ? std::string(name_of(*one.edge)) : one.rim, stress, &one.amplitude});
  }
  for (const Pressure& one : loads.pressures)
    all.push_back({"pressure", one.rim, one.pressure, &one.amplitude});
  for (const BodyForce& one : loads.body_forces)
    all.push_back({"body force", "", {}, &one.amplitude});
  for (const Support& one : loads.supports) {
    // A clamp acts the same with any amplitude.
    if (!one.value.is_constant() || one.value.constant().norm() > 0.0)
      all.push_back({"support", "", {}, &one.amplitude});
  }
  for (const ThermalLoad& one : loads.thermal_loads)
    all.push_back({"temperature", "", {}, &one.amplitude});
  return all;
}

// Returns points from t = 0 to `until`; for a function its present value.
std::vector<Vec2> points_of(const Amplitude& amplitude, double size, double now, double until) {
  if (amplitude.is_function()) return {{now, size * amplitude.at(now)}};
  std::vector<Vec2> points{{0.0, size * amplitude.at(0.0)}};
  for (const Vec2& point : amplitude.points())
    if (point.x() > 0.0 && point.x() < until) points.emplace_back(point.x(), size * point.y());
  points.emplace_back(until, size * amplitude.at(until));
  return points;
}

double last_moment(const std::vector<LoadAmplitude>& amplitudes) {
  double last = 0.0;
  for (const LoadAmplitude& one : amplitudes)
    for (const Vec2& point : one.amplitude->points()) last = std::max(last, point.x());
  return last;
}

// Distinguishes loads of the same kind and place.
void number_places(std::vector<LoadAmplitude>& loads) {
  for (std::size_t k = 0; k < loads.size(); ++k) {
    int number = 1;
    for (std::size_t other = k + 1; other < loads.size(); ++other) {
      if (loads[other].kind != loads[k].kind || loads[other].place != loads[k].place) continue;
      loads[other].place += fmt::format("{}{}", loads[k].place.empty() ? "" : " ", ++number);
    }
  }
}

}  // namespace

Chart load_curve(const View& view) {
  std::vector<LoadAmplitude> amplitudes = amplitudes_of(view.plate().loads);
  number_places(amplitudes);
  const double now = view.time();
  Chart chart;
  const bool stresses = std::ranges::all_of(
      amplitudes, [](const LoadAmplitude& one) { return one.stress.has_value(); });
  chart.heading = amplitudes.empty() ? "no loads" : stresses ? "load" : "load factor";
  if (stresses && !amplitudes.empty()) chart.unit = "Pa";
  // The whole course, also what is to come; constant loads have no end of their own.
  chart.until = std::max(view.until(), 1.25 * last_moment(amplitudes));
  if (chart.until == 0.0) chart.until = 100.0 * view.dt();
  for (const LoadAmplitude& one : amplitudes)
    chart.curves.push_back(
        {one.kind, one.place,
         points_of(*one.amplitude, stresses ? *one.stress : 1.0, now, chart.until)});
  return chart;
}

Chart energy_chart(const View& view) {
  const Energy now = energy(view);
  const double time = view.time();
  Chart chart{"energy",
              "J/m",
              view.until(),
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
