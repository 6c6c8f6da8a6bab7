// SPDX-License-Identifier: MIT
#include "output/report/load_remarks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "base/units.hpp"
#include "lattice/load_map.hpp"

namespace hackle {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();
constexpr double min_share = 0.1;  // of the largest factor

using Corners = std::vector<Vec2>;  // (t, factor), as in a Amplitude

// Corners first <= k <= last, along which the factor only rises, only falls, or stays.
struct Stroke {
  std::size_t first, last;
  double height;  // signed
};

Corners corners_of(const Amplitude& amplitude, double begin, double end) {
  Corners corners;
  if (begin <= 0.0) corners.emplace_back(0.0, 0.0);
  corners.emplace_back(begin, amplitude.at(begin));
  for (const Vec2& point : amplitude.points())
    if (point.x() > begin && point.x() <= end) corners.push_back(point);
  return corners;
}

Corners samples_of(const Amplitude& amplitude, double begin, double end, std::int64_t count) {
  Corners corners;
  if (begin <= 0.0) corners.emplace_back(0.0, 0.0);
  for (std::int64_t k = 0; k <= count; ++k) {
    const double t = begin + (end - begin) * static_cast<double>(k) / static_cast<double>(count);
    corners.emplace_back(t, amplitude.at(t));
  }
  return corners;
}

std::vector<Stroke> strokes_of(const Corners& corners) {
  std::vector<Stroke> strokes;
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    const double change = corners[k + 1].y() - corners[k].y();
    if (change == 0.0) continue;
    if (strokes.empty() || (change > 0.0) != (strokes.back().height > 0.0))
      strokes.push_back({k, k, 0.0});
    strokes.back().last = k + 1;
    strokes.back().height += change;
  }
  return strokes;
}

// Returns when the stroke passes this factor.
double passes(const Corners& corners, const Stroke& stroke, double factor) {
  for (std::size_t k = stroke.first; k < stroke.last; ++k) {
    const Vec2 &one = corners[k], &other = corners[k + 1];
    if ((one.y() - factor) * (other.y() - factor) > 0.0 || one.y() == other.y()) continue;
    return one.x() + (factor - one.y()) / (other.y() - one.y()) * (other.x() - one.x());
  }
  return corners[stroke.last].x();
}

// A swing, and its middle.
struct Swing {
  double length = forever;
  double when = 0.0;
};

Swing shortest_of(const Corners& corners) {
  double max = 0.0;
  for (const Vec2& corner : corners) max = std::max(max, std::abs(corner.y()));
  const std::vector<Stroke> strokes = strokes_of(corners);
  Swing shortest;
  for (std::size_t k = 0; k + 1 < strokes.size(); ++k) {
    const Stroke &there = strokes[k], &back = strokes[k + 1];
    const double height = std::min(std::abs(there.height), std::abs(back.height));
    if (height < min_share * max) continue;
    const double middle = corners[there.last].y() - std::copysign(0.5 * height, there.height);
    const double from = passes(corners, there, middle), to = passes(corners, back, middle);
    if (to - from < shortest.length) shortest = {to - from, 0.5 * (from + to)};
  }
  return shortest;
}

// Refines the samples of the swing until it consists of many.
double shortest_of_function(const Amplitude& amplitude, double begin, double end, double dt) {
  constexpr double max_samples = 16384.0, closest = 64.0, finest = 1e-6;
  const double steps = std::max(1.0, std::ceil((end - begin) / dt));
  double gap = dt / std::clamp(std::floor(max_samples / steps), 2.0, closest);
  if (steps > max_samples) return forever;  // this would take too long
  Swing swing = shortest_of(
      samples_of(amplitude, begin, end, static_cast<std::int64_t>(std::ceil((end - begin) / gap))));
  while (swing.length < 8.0 * gap && swing.length < steps_a_swing * dt && gap > finest * dt) {
    const double reach = 32.0 * gap;
    gap /= 8.0;
    const Swing closer = shortest_of(samples_of(amplitude, std::max(begin, swing.when - reach),
                                                std::min(end, swing.when + reach), 512));
    if (!(closer.length < forever)) break;
    swing = closer;
  }
  return swing.length;
}

void add_swing(const std::string& who, const Amplitude& amplitude, double begin, double end,
               double dt, std::vector<std::string>& list) {
  const double length = shortest_swing(amplitude, begin, end, dt);
  if (!(length < steps_a_swing * dt)) return;
  list.push_back(
      fmt::format("{} comes and goes within {}, which steps of {} do not resolve: give a step of "
                  "{} or less, or "
                  "let it last for {} or more",
                  who, quantity(length, "s"), quantity(dt, "s"),
                  quantity(length / steps_a_swing, "s"), quantity(steps_a_swing * dt, "s")));
}

// The largest fall and the largest rise within a step; the first includes the value at the
// beginning.
struct Jumps {
  double down = 0.0;
  double up = 0.0;
};

Jumps jumps_of(const Amplitude& amplitude, double begin, double end, double dt) {
  Jumps jumps;
  if (amplitude.is_constant()) return jumps;
  const auto take = [&](double from, double to) {
    jumps.down = std::max(jumps.down, from - to);
    jumps.up = std::max(jumps.up, to - from);
  };
  Corners moments = corners_of(amplitude, begin, end);
  if (amplitude.is_function()) moments = samples_of(amplitude, begin, end, 1024);
  for (const Vec2& moment : moments) {
    const double t = moment.x();
    if (t - dt >= begin) take(amplitude.at(t - dt), amplitude.at(t));
    if (t + dt <= end) take(amplitude.at(t), amplitude.at(t + dt));
  }
  return jumps;
}

// Describes bonds at rest whose ends shrink by `shrinkage`.
std::string shock_text(double shrinkage, double s0) {
  return fmt::format(
      "temperature: it stretches bonds by {:.2g} at once, s0 is {:.2g}: they break in the step "
      "that finds them, all together; let the change come over a time, with a ramp",
      shrinkage, s0);
}

// Describes the first node whose bonds break suddenly by such jumps of temperature.
std::optional<std::string> shock_of(const SpreadHeat& heat, const Jumps& jumps,
                                    const Lattice& lattice) {
  const NodeRange& range = heat.range;
  for (int j = range.first_j; j <= range.last_j; ++j)
    for (int i = range.first_i; i <= range.last_i; ++i) {
      const double strain = heat.strain[range.index(i, j)];
      const double shrinkage = std::max(jumps.down * strain, -jumps.up * strain);
      if (shrinkage <= 0.0) continue;
      const double s0 = lattice.critical_stretch_at(i, j);
      if (shrinkage > s0) return shock_text(shrinkage, s0);
    }
  return std::nullopt;
}

std::optional<std::string> first_shock(const Simulation& simulation, double end) {
  const std::vector<ThermalLoad>& thermal_loads = simulation.plate().loads.thermal_loads;
  std::vector<SpreadHeat> spread;  // evaluates functions of place: only where needed
  for (std::size_t k = 0; k < thermal_loads.size(); ++k) {
    const Jumps jumps =
        jumps_of(thermal_loads[k].amplitude, simulation.time_of_step(), end, simulation.dt());
    if (jumps.down == 0.0 && jumps.up == 0.0) continue;
    if (spread.empty()) spread = spread_heat(simulation.plate(), simulation.lattice());
    if (auto shock = shock_of(spread[k], jumps, simulation.lattice())) return shock;
  }
  return std::nullopt;
}

// Returns how far a prescribed node moves in a step beyond its previous motion, in spacings: in the
// next step, and at the jumps of the amplitude.
double sudden_move(const HeldNode& node, const SpreadSupport& support, const Jumps& jumps,
                   const Simulation& simulation, bool fresh) {
  const bool led = support.kind == Support::Kind::velocity;
  const double dt = simulation.dt(), dx = simulation.lattice().grid.dx;
  const Vec2 along(node.along_x ? 1.0 : 0.0, node.along_y ? 1.0 : 0.0);
  const double unit = led ? dt / dx : 1.0 / dx;
  double max = std::max(jumps.down, jumps.up) * unit * node.value.cwiseProduct(along).norm();
  if (!fresh) return max;
  const double next = simulation.time_of_step() + (led ? 0.5 : 1.0) * dt;
  const Vec2 now = led ? simulation.state().v(node.i, node.j)
                       : simulation.view().at_step().displacement(node.i, node.j) / dx;
  const Vec2 sudden = unit * support.amplitude.at(next) * node.value - now;
  return std::max(max, sudden.cwiseProduct(along).norm());
}

std::string blow_text(const Simulation& simulation, Support::Kind kind, double stretch, double s0) {
  std::string remedy = "let it come over a time, with a ramp";
  if (kind == Support::Kind::velocity)
    remedy += fmt::format(", or give a step of {} or less",
                          quantity(simulation.dt() * s0 / stretch, "s"));
  return fmt::format(
      "support: it moves so much in a step that it stretches bonds by up to {:.2g}, s0 is {:.2g}: "
      "they break in the step that finds them, and its work is not known; {}",
      stretch, s0, remedy);
}

// Describes the first node that moves so far in a step that its bonds to free nodes break.
std::optional<std::string> first_blow(const Simulation& simulation, double end, bool fresh) {
  const std::vector<Support>& supports = simulation.plate().loads.supports;
  std::vector<SpreadSupport> spread;
  for (std::size_t k = 0; k < supports.size(); ++k) {
    const Jumps jumps =
        jumps_of(supports[k].amplitude, simulation.time_of_step(), end, simulation.dt());
    if (!fresh && jumps.down == 0.0 && jumps.up == 0.0) continue;
    if (spread.empty()) spread = spread_supports(simulation.plate(), simulation.lattice());
    for (const HeldNode& node : spread[k].nodes) {
      const double stretch = sudden_move(node, spread[k], jumps, simulation, fresh);
      const double s0 = simulation.lattice().critical_stretch_at(node.i, node.j);
      if (stretch > s0) return blow_text(simulation, spread[k].kind, stretch, s0);
    }
  }
  return std::nullopt;
}

}  // namespace

double shortest_swing(const Amplitude& amplitude, double begin, double end, double dt) {
  if (amplitude.is_constant() || !(end > begin)) return forever;
  if (amplitude.is_function()) return shortest_of_function(amplitude, begin, end, dt);
  return shortest_of(corners_of(amplitude, begin, end)).length;
}

std::vector<std::string> load_remarks(const Simulation& simulation, double end) {
  const Loads& loads = simulation.plate().loads;
  const double begin = simulation.time_of_step(), dt = simulation.dt();
  std::vector<std::string> list;
  for_each_list(loads, [&](const auto& kind) {
    using Load = typename std::remove_cvref_t<decltype(kind)>::value_type;
    if constexpr (requires(const Load& load) { load.amplitude; })
      for (std::size_t k = 0; k < kind.size(); ++k) {
        const std::string_view who = description_of<Load>.noun;
        add_swing(kind.size() == 1 ? std::string(who) : fmt::format("{} {}", who, k + 1),
                  kind[k].amplitude, begin, end, dt, list);
      }
  });
  return list;
}

std::vector<std::string> at_once_remarks(const Simulation& simulation, double end, bool fresh) {
  std::vector<std::string> list;
  if (const auto shock = first_shock(simulation, end)) list.push_back(*shock);
  if (const auto blow = first_blow(simulation, end, fresh)) list.push_back(*blow);
  return list;
}

std::vector<std::string> shock_remarks(const Simulation& simulation,
                                       const std::vector<double>& before) {
  const Lattice& lattice = simulation.lattice();
  const std::vector<double>& now = simulation.thermal_strain();
  double worst = 1.0, shrinkage = 0.0, s0 = 0.0;
  for (int j = 0; j < lattice.grid.ny && !now.empty(); ++j)
    for (int i = 0; i < lattice.grid.nx; ++i) {
      const std::size_t node = lattice.grid.index(i, j);
      const double shrinks = (before.empty() ? 0.0 : before[node]) - now[node];
      const double own = lattice.critical_stretch_at(i, j);
      if (lattice.is_void(i, j) || shrinks <= worst * own) continue;
      worst = shrinks / own;
      shrinkage = shrinks;
      s0 = own;
    }
  if (s0 == 0.0) return {};
  return {shock_text(shrinkage, s0)};
}

}  // namespace hackle
