// SPDX-License-Identifier: MIT
#include "app/accuracy.hpp"

#include <cmath>

#include <fmt/format.h>

#include "app/bench_deck.hpp"
#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/stopwatch.hpp"
#include "base/units.hpp"
#include "measure/cracks.hpp"
#include "measure/energy.hpp"

namespace hackle {
namespace {

constexpr int checks = 128;  // checks of the crack during the run

Plate plate_for(const Numerics& numerics) {
  Plate plate = bench_deck({}, 1000).plate;
  plate.no_fail.clear();
  for (const Edge edge : {Edge::top, Edge::bottom})
    plate.no_fail.push_back(strip(plate, edge, numerics.horizon_or_default()));
  return plate;
}

Numerics with_step(Numerics numerics, double share_of_limit) {
  numerics.step = share_of_limit * Lattice(plate_for(numerics), numerics).step_limit;
  return numerics;
}

Numerics on_lattice(double spacing, double horizon) {
  Numerics numerics;
  numerics.spacing = spacing;
  numerics.horizon = horizon;
  return numerics;
}

Simulation solved_until(const Numerics& numerics, double time, InstructionSet set) {
  Simulation simulation(plate_for(numerics), numerics, {1, set});
  simulation.run(time);
  return simulation;
}

double relative(double difference, double of) {
  return of > 0.0 ? std::sqrt(difference / of) : 0.0;
}

double difference(const Simulation& one, const Simulation& exact) {
  const Grid& grid = one.lattice().grid;
  double sum = 0.0, of = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const Vec2 u = exact.displacement(i, j);
      sum += (one.displacement(i, j) - u).squaredNorm();
      of += u.squaredNorm();
    }
  return relative(sum, of);
}

// A cell of the lattice covers four of the finer one: their mean is compared.
double difference_to_finer(const Simulation& one, const Simulation& finer) {
  const Grid& grid = one.lattice().grid;
  double sum = 0.0, of = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      Vec2 u{0, 0};
      for (const int b : {0, 1})
        for (const int a : {0, 1}) u += 0.25 * finer.displacement(2 * i + a, 2 * j + b);
      sum += (one.displacement(i, j) - u).squaredNorm();
      of += u.squaredNorm();
    }
  return relative(sum, of);
}

void compare(const Simulation& simulation, TradeResult& result) {
  const Numerics& given = simulation.numerics();
  Numerics exact = on_lattice(given.spacing, given.horizon_or_default());
  exact.quadrature = given.quadrature;
  const InstructionSet set = simulation.instruction_set();
  result.to_exact = difference(simulation, solved_until(exact, trade_sample, set));
  Numerics finer = exact;
  finer.spacing *= 0.5;
  result.to_finer = difference_to_finer(simulation, solved_until(finer, trade_sample, set));
}

void look(const Simulation& simulation, TradeResult& result) {
  result.tip_place = tip_place(nodes_on_crack(damage(simulation)), simulation.lattice().grid);
  const auto broken = simulation.lattice().bonds.count() - simulation.state().bonds.count();
  if (broken > 0 && !result.first_bond) result.first_bond = simulation.time();
  if (result.fork_time) return;
  result.fork_place = cracks(simulation).fork;
  if (result.fork_place) result.fork_time = simulation.time();
}

}  // namespace

std::vector<Trade> trades() {
  const Numerics plain = on_lattice(0.5e-3, 2e-3);
  std::vector<Trade> list{{"f64", plain}};
  const auto add = [&](std::string name, const auto& change) {
    Numerics numerics = plain;
    change(numerics);
    list.push_back({std::move(name), numerics});
  };
  add("f64 fused", [](Numerics& n) { n.fused = true; });
  add("f32", [](Numerics& n) { n.precision = Precision::f32; });
  for (const double fraction : {0.25, 0.5, 0.98})
    add(fmt::format("step {} of the limit", fraction),
        [&](Numerics& n) { n = with_step(n, fraction); });
  for (const double fidelity : {0.1, 0.25, 0.5, 1.0})
    add(fmt::format("fidelity {}", fidelity), [&](Numerics& n) { n.fidelity = fidelity; });
  add("breaking next_step", [](Numerics& n) { n.breaking = Breaking::next_step; });
  add("quadrature ramp", [](Numerics& n) { n.quadrature = Quadrature::ramp; });
  for (const int m : {3, 6})
    list.push_back({fmt::format("horizon {} spacings", m), on_lattice(0.5e-3, m * 0.5e-3)});
  for (const double spacing : {1e-3, 0.25e-3})
    list.push_back({"spacing " + quantity(spacing, "m"), on_lattice(spacing, 4.0 * spacing)});
  return list;
}

TradeResult measure_trade(const Trade& trade, InstructionSet set) {
  TradeResult result;
  result.name = trade.name;
  Simulation simulation(plate_for(trade.numerics), trade.numerics, {1, set});
  result.nodes = static_cast<std::int64_t>(simulation.lattice().grid.nodes());
  compare(solved_until(trade.numerics, trade_sample, set), result);
  for (int sample = 1; sample <= checks; ++sample) {
    simulation.run(trade_end / checks);
    look(simulation, result);
  }
  const Energy ledger = energy(simulation);
  result.residual = ledger.residual() / ledger.external;
  result.broken = count_damage(simulation).broken_bonds;
  result.seconds = simulation.solve_seconds();
  result.node_steps_per_second =
      static_cast<double>(result.nodes * simulation.state().step) / simulation.solve_seconds();
  return result;
}

}  // namespace hackle
