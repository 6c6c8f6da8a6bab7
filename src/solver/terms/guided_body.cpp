// SPDX-License-Identifier: MIT
#include "solver/terms/guided_body.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "lattice/carve.hpp"
#include "lattice/touching.hpp"
#include "solver/terms/cell_overlap.hpp"

namespace hackle {
namespace {

Vec2 middle_of(const Roller& roller) {
  return roller.centre;
}
Vec2 middle_of(const Platen& platen) {
  return 0.5 * (platen.from + platen.to);
}
double radius_of(const Roller& roller) {
  return roller.radius;
}
double radius_of(const Platen&) {
  return 0.0;
}
Vec2 half_of(const Roller& roller) {
  return {roller.radius, roller.radius};
}
Vec2 half_of(const Platen& platen) {
  return 0.5 * (platen.to - platen.from).cwiseAbs();
}

template <class Load>
GuidedBody body_of(const Load& load, const Lattice& lattice, double dt) {
  const Grid& grid = lattice.grid;
  const double dx = grid.dx, node = lattice.rho * dx * dx;
  const Guided& guided = load.guided;
  const double unit = guided.guide == Guide::force ? node * dx / (dt * dt) : dx;
  return {description_of<Load>.noun,
          guided.name,
          guided.guide,
          grid.from_centre(middle_of(load)),
          radius_of(load) / dx,
          half_of(load) / dx,
          breadth_of(load) / dx,
          mass_of(guided, area_of(load)) / node,
          guided.value / unit,
          TabulatedAmplitude(guided.amplitude, 0.0),
          {guided.friction, 1.0}};
}

void check_size(const GuidedBody& body, const Lattice& lattice) {
  const double dx = lattice.grid.dx;
  const double min = body.radius > 0.0 ? body.radius : 2.0 * body.half.minCoeff();
  if (min < 1.0)
    throw Error(ErrorKind::refused,
                fmt::format("{}: its {} of {} is under one spacing of {}", body.who,
                            body.radius > 0.0 ? "radius" : "smaller side", quantity(min * dx, "m"),
                            quantity(dx, "m")),
                "take a larger one or a finer spacing");
}

// A body lighter than the nodes it pushes at once would be thrown back faster than it came.
void check_guide(const GuidedBody& body, const Lattice& lattice) {
  if (body.guide == Guide::velocity && body.amplitude.amplitude().is_function())
    throw Error(ErrorKind::refused,
                fmt::format("{}: a velocity goes with a table of times, not with a function of "
                            "time",
                            body.who),
                "give a table of times and factors, or displacement instead of velocity");
  const double node = lattice.rho * lattice.grid.dx * lattice.grid.dx;
  if (body.is_pressed() && body.mass < body.breadth)
    throw Error(ErrorKind::refused,
                fmt::format("{}: its mass of {} is less than that of the nodes it pushes", body.who,
                            quantity(body.mass * node, "kg/m")),
                fmt::format("give at least {}", quantity(body.breadth * node, "kg/m")));
}

void check_start(const GuidedBody& body, const Lattice& lattice) {
  double deepest = 0.0;
  for_nodes(lattice.grid, [&](int i, int j) {
    if (!lattice.is_void(i, j))
      deepest = std::max(deepest, body.overlap(lattice.grid.from_centre(i, j), body.start).norm());
  });
  if (deepest > tie)
    throw Error(ErrorKind::refused,
                fmt::format("{}: before it moves it overlaps the plate by {}", body.who,
                            quantity(deepest * lattice.grid.dx, "m")),
                "let it begin beside the plate or in a hole");
}

}  // namespace

Vec2 GuidedBody::overlap(const Vec2& node, const Vec2& centre, double more) const {
  return radius > 0.0 ? overlap_with_disc(node, centre, radius + more)
                      : overlap_with_box(node, centre, half + Vec2(more, more));
}

Vec2 GuidedBody::force(const Clock& clock, std::int64_t step, double dt) const {
  return amplitude.at(clock, step, dt) * value;
}

Vec2 GuidedBody::centre(const Clock& clock, std::int64_t step, double dt) const {
  if (guide == Guide::displacement) return start + amplitude.at(clock, step, dt) * value;
  const double time = clock.time(step, 0.0, dt);
  return start + time * amplitude.amplitude().mean(0.0, time) * value;
}

Disc GuidedBody::start_of(const Clock& clock, std::int64_t step, double dt) const {
  if (!is_pressed()) return {centre(clock, step, dt), {0, 0}};
  return {start, -0.5 / mass * force(clock, step, dt)};
}

void GuidedBody::tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double dt) {
  amplitude.tabulate(clock, begin, end, dt);
  if (is_pressed() || value.isZero(0.0)) return;
  for (std::int64_t step = begin; step + 1 < end; ++step) {
    const double way = (centre(clock, step + 1, dt) - centre(clock, step, dt)).norm();
    if (way <= max_crossed * (1.0 + 1e-6)) continue;
    throw Error(ErrorKind::refused,
                fmt::format("{}: in the step at {} it crosses {:.2g} spacings, {:g} are the most",
                            who, quantity(clock.time(step, 0.0, dt), "s"), way, max_crossed),
                "lead it more slowly, without jumps, or take a smaller step");
  }
}

std::vector<GuidedBody> guided_bodies(const Plate& plate, const Lattice& lattice, double dt) {
  std::vector<GuidedBody> bodies;
  for_each_guided(plate.loads, [&](const auto& load) {
    const GuidedBody& body = bodies.emplace_back(body_of(load, lattice, dt));
    check_size(body, lattice);
    check_guide(body, lattice);
    check_start(body, lattice);
  });
  return bodies;
}

}  // namespace hackle
