// SPDX-License-Identifier: MIT
#include "solver/state.hpp"

#include <functional>

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

// A state in which nothing is 0.
State busy(Precision precision) {
  static const Lattice lattice(test::bare_plate(12, 9), test::numerics());
  State state(lattice, precision);
  std::visit([](auto& motion) { motion.threshold.assign(motion.ux.size(), 1); }, state.motion);
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 12; ++i) {
      state.set_u(i, j, {0.5 + i, 0.25 * j});
      state.set_v(i, j, {1.0 / (1 + i), -2.0 * j});
    }
  state.step = state.start = 7;
  state.external_work = 1.0;
  state.damped = 3.0;
  state.released = 3.25;
  state.contact_lost = 3.125;
  state.clock = {1e-6, 2};
  state.origin = {4.0, 5.0};
  state.discs = {{{6.0, 7.0}, {8.0, 9.0}}, {{1.0, 2.0}, {3.0, 4.0}}};
  state.rollers = {{{1.0, 2.0}, {0.0, 1.0}}};
  state.platens = {{{5.0, 2.0}, {0.0, 1.0}}};
  return state;
}

struct Change {
  const char* member;
  std::function<void(State&)> make;
};

// Two states have the same hash only when every member is the same.
TEST(StateHash, KnowsEveryMember) {
  const Change changes[] = {
      {"ux", [](State& s) { s.set_u(3, 4, s.u(3, 4) + Vec2(1, 0)); }},
      {"uy", [](State& s) { s.set_u(11, 8, s.u(11, 8) + Vec2(0, 1)); }},
      {"vx", [](State& s) { s.set_v(0, 0, s.v(0, 0) + Vec2(1, 0)); }},
      {"vy", [](State& s) { s.set_v(11, 0, s.v(11, 0) + Vec2(0, 1)); }},
      {"threshold",
       [](State& s) {
         const auto at = static_cast<std::size_t>(s.layout.at(5, 5));
         std::visit([at](auto& motion) { motion.threshold[at] = 2; }, s.motion);
       }},
      {"bonds", [](State& s) { s.bonds.clear(s.layout.at(5, 5), 3); }},
      {"step and start", [](State& s) { s.step = s.start = 8; }},
      {"start", [](State& s) { s.start = 6; }},
      {"external_work", [](State& s) { s.external_work = 1.5; }},
      {"damped", [](State& s) { s.damped = 3.5; }},
      {"released", [](State& s) { s.released = 3.75; }},
      {"contact_lost", [](State& s) { s.contact_lost = 4.25; }},
      {"moment of the clock", [](State& s) { s.clock.moment = 2e-6; }},
      {"step of the clock", [](State& s) { s.clock.since = 3; }},
      {"origin x", [](State& s) { s.origin.x() = 4.5; }},
      {"origin y", [](State& s) { s.origin.y() = 5.5; }},
      {"centre of a disc", [](State& s) { s.discs[0].centre.x() = 6.5; }},
      {"centre of another", [](State& s) { s.discs[1].centre.y() = 2.5; }},
      {"velocity of a disc", [](State& s) { s.discs[0].velocity.y() = 9.5; }},
      {"centre of a roller", [](State& s) { s.rollers[0].centre.x() = 6.5; }},
      {"velocity of a platen", [](State& s) { s.platens[0].velocity.y() = 9.5; }},
      {"velocity of another", [](State& s) { s.discs[1].velocity.x() = 3.5; }},
  };
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    const State state = busy(precision);
    for (const Change& change : changes) {
      State other = state;
      change.make(other);
      EXPECT_NE(other.hash(), state.hash()) << change.member;
    }
    EXPECT_EQ(State(state).hash(), state.hash());
  }
}

// What lies beside the plate means nothing.
TEST(StateHash, LooksAtNoGhost) {
  const State state = busy(Precision::f64);
  State other = state;
  std::get<Motion<double>>(other.motion).ux[static_cast<std::size_t>(other.layout.at(12, 3))] = 9.0;
  EXPECT_EQ(other.hash(), state.hash());
}

}  // namespace
}  // namespace hackle
