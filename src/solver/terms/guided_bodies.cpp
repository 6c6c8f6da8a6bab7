// SPDX-License-Identifier: MIT
// Rollers and platens: rigid discs and boxes that a machine leads. They push every node whose cell
// they overlap by the law of impactors (impact.hpp); a box pushes along the axis by which it is
// left sooner. What the machine does is the work of a load.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "lattice/carve.hpp"
#include "solver/tabulated_amplitude.hpp"
#include "solver/terms/cell_overlap.hpp"
#include "solver/terms/forces.hpp"
#include "solver/terms/makers.hpp"
#include "solver/terms/roughness.hpp"

namespace hackle {
namespace {

struct Body {
  std::string_view who;
  Vec2 start{0, 0};     // from the centre of the lattice, here as below in dx
  double radius = 0.0;  // of a disc
  Vec2 half{0, 0};      // of a box
  Guide guide;
  Vec2 value{0, 0};  // dx, or dx per s
  TabulatedAmplitude amplitude;
  Roughness roughness;
  std::vector<std::size_t> near{};  // nodes that it may push until they are watched again

  // Returns the overlap with the cell of a node, as a vector out of the body; 0 for none.
  Vec2 overlap(const Vec2& node, const Vec2& centre, double more = 0.0) const {
    return radius > 0.0 ? overlap_with_disc(node, centre, radius + more)
                        : overlap_with_box(node, centre, half + Vec2(more, more));
  }
  Vec2 centre(const State& state, std::int64_t step, double dt) const {
    if (guide == Guide::displacement) return start + amplitude.at(state.clock, step, dt) * value;
    const double time = state.clock.time(step, 0.0, dt);
    return start + time * amplitude.amplitude().mean(0.0, time) * value;
  }
};

void check_body(const Body& body, const Lattice& lattice) {
  const double dx = lattice.grid.dx;
  const double min = body.radius > 0.0 ? body.radius : 2.0 * body.half.minCoeff();
  if (min < 1.0)
    throw Error(ErrorKind::refused,
                fmt::format("{}: its {} of {} is under one spacing of {}", body.who,
                            body.radius > 0.0 ? "radius" : "smaller side", quantity(min * dx, "m"),
                            quantity(dx, "m")),
                "take a larger one or a finer spacing");
  if (body.guide == Guide::velocity && body.amplitude.amplitude().is_function())
    throw Error(ErrorKind::refused,
                fmt::format("{}: a velocity goes with a table of times, not with a function of "
                            "time",
                            body.who),
                "give a table of times and factors, or displacement instead of velocity");
  double deepest = 0.0;
  for_nodes(lattice.grid, [&](int i, int j) {
    if (!lattice.is_void(i, j))
      deepest = std::max(deepest, body.overlap(lattice.grid.from_centre(i, j), body.start).norm());
  });
  if (deepest > tie)
    throw Error(ErrorKind::refused,
                fmt::format("{}: before it moves it overlaps the plate by {}", body.who,
                            quantity(deepest * dx, "m")),
                "let it begin beside the plate or in a hole");
}

class GuidedBodies final : public Term {
 public:
  GuidedBodies(const Plate& plate, const Lattice& lattice, double dt)
      : strength_(strength_of_push(plate, lattice, dt)) {
    const Grid& grid = lattice.grid;
    for (const Roller& roller : plate.loads.rollers)
      add(body_of("roller", roller, grid, grid.from_centre(roller.centre), roller.radius / grid.dx,
                  {0, 0}),
          lattice);
    for (const Platen& platen : plate.loads.platens)
      add(body_of("platen", platen, grid, grid.from_centre(0.5 * (platen.from + platen.to)), 0.0,
                  0.5 / grid.dx * (platen.to - platen.from).cwiseAbs()),
          lattice);
  }

  std::unique_ptr<Term> clone() const override { return std::make_unique<GuidedBodies>(*this); }
  std::string_view name() const override { return "rollers and platens"; }
  void tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double dt) override {
    for (Body& body : bodies_) body.amplitude.tabulate(clock, begin, end, dt);
  }
  void begin(const Surroundings&, State& state) override { watch_again_ = state.step; }
  bool update(const Surroundings& around, State& state) override {
    const bool touched = !forces_.empty();
    if (state.step >= watch_again_) watch(around, state);
    forces_.clear();
    for (const Body& body : bodies_)
      forces_ = sum_of(forces_, pushes_of(body, around, state), around.lattice.grid);
    return touched || !forces_.empty();
  }
  std::span<const LoadedNode> forces() const override { return forces_; }
  bool varies() const override { return true; }
  void add_work(const Surroundings& around, const State& state, WorkOf part,
                double& work) const override {
    add_work_of(forces_, around, state, part, work);
  }
  void check_rest(const std::string& who) const override {
    throw Error(
        ErrorKind::refused,
        fmt::format("{}: a plate between rollers or platens cannot be brought to rest", who),
        "let s:damping{} calm it while it runs, or use p:clamp and p:move instead");
  }

 private:
  template <class Guided>
  static Body body_of(std::string_view who, const Guided& guided, const Grid& grid,
                      const Vec2& start, double radius, const Vec2& half) {
    return {who,
            start,
            radius,
            half,
            guided.guide,
            guided.value / grid.dx,
            TabulatedAmplitude(guided.amplitude, 0.0),
            {guided.friction, 1.0}};
  }

  void add(Body body, const Lattice& lattice) {
    check_body(body, lattice);
    bodies_.push_back(std::move(body));
  }

  // Returns the way of a body in the last step.
  static Vec2 velocity_of(const Body& body, const State& state, double dt) {
    if (state.step == 0) return {0, 0};
    return body.centre(state, state.step, dt) - body.centre(state, state.step - 1, dt);
  }

  // Valid until a node could have crossed the watched margin, if no speed doubles. If one does, the
  // node is found a little later.
  void watch(const Surroundings& around, const State& state) {
    const Lattice& lattice = around.lattice;
    double fastest = 0.0, fastest_body = 0.0;
    std::vector<Vec2> centres;
    for (Body& body : bodies_) {
      body.near.clear();
      centres.push_back(body.centre(state, state.step, around.dt));
      fastest_body = std::max(fastest_body, velocity_of(body, state, around.dt).norm());
    }
    for (int j = 0; j < lattice.grid.ny; ++j)
      for (int i = 0; i < lattice.grid.nx; ++i) {
        if (lattice.is_void(i, j)) continue;
        fastest = std::max(fastest, state.v(i, j).norm());
        for (std::size_t k = 0; k < bodies_.size(); ++k)
          if (!bodies_[k]
                   .overlap(place_now(lattice.grid, state, i, j), centres[k], watched)
                   .isZero(0.0))
            bodies_[k].near.push_back(lattice.grid.index(i, j));
      }
    const double approach = 2.0 * (fastest + fastest_body);
    const double steps = approach > 0.0 ? watched / approach : 1.0;
    watch_again_ = state.step + static_cast<std::int64_t>(std::clamp(steps, 1.0, 16.0));
  }

  std::vector<LoadedNode> pushes_of(const Body& body, const Surroundings& around,
                                    const State& state) const {
    const Lattice& lattice = around.lattice;
    const Grid& grid = lattice.grid;
    const double unit = grid.dx / (around.dt * around.dt);
    const Vec2 centre = body.centre(state, state.step, around.dt);
    const Vec2 velocity = velocity_of(body, state, around.dt);
    std::vector<LoadedNode> pushed;
    for (const std::size_t node : body.near) {
      const auto columns = static_cast<std::size_t>(grid.nx);
      const int i = static_cast<int>(node % columns), j = static_cast<int>(node / columns);
      const Vec2 overlap = body.overlap(place_now(grid, state, i, j), centre);
      if (overlap.isZero(0.0)) continue;
      const double inertia = lattice.material_at(i, j).material.rho / lattice.rho;
      Vec2 force = strength_ * lattice.micromodulus_at(i, j) / lattice.calibration.c * overlap;
      force += loss_of(body.roughness, force, state.v(i, j) - velocity, hold_of_body * inertia);
      pushed.push_back({i, j, force * (unit / inertia), inertia});
    }
    return pushed;
  }

  std::vector<Body> bodies_;
  double strength_;               // force on a node of the plate's own material, per overlap
  std::int64_t watch_again_ = 0;  // step
  std::vector<LoadedNode> forces_;
};

}  // namespace

std::unique_ptr<Term> make_guided_bodies(const Plate& plate, const Lattice& lattice, double dt) {
  if (plate.loads.rollers.empty() && plate.loads.platens.empty()) return nullptr;
  return std::make_unique<GuidedBodies>(plate, lattice, dt);
}

}  // namespace hackle
