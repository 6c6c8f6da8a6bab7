// SPDX-License-Identifier: MIT
#include "measure/crack_track.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "measure/cracks.hpp"
#include "measure/energy.hpp"
#include "measure/field.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

Numerics coarse() {
  return test::numerics(1e-3, 4e-3);
}

void expect_known(const CrackTrack& track, const Simulation& simulation, const Vec2& direction) {
  const DamageCount count = count_damage(simulation);
  EXPECT_EQ(track.broken_bonds(), count.broken_bonds);
  EXPECT_NEAR(track.max_damage(), count.max, 1e-6);  // which is a float
  const double broken = energy(simulation).broken;
  EXPECT_NEAR(track.broken_energy(), broken, 1e-10 * broken);
  const auto tip = foremost(damage(simulation), simulation.lattice().grid, direction);
  ASSERT_TRUE(tip && track.tip());
  EXPECT_LT((*tip - *track.tip()).norm(), 1e-9);
}

// What is kept up to date is what a look at the whole plate finds.
TEST(CrackTrack, FollowsWhatBreaksAsALookAtEveryBondFindsIt) {
  Simulation simulation(test::edge_crack(24e6), coarse(), {1});
  CrackTrack track, aside({0.0, 1.0});
  for (int step = 0; step < 120; ++step) {
    track.follow(simulation);
    aside.follow(simulation);
    if (step % 30 == 29) expect_known(track, simulation, {1.0, 0.0});
    simulation.step();
  }
  EXPECT_GT(track.broken_bonds(), 500);
  track.follow(simulation);
  aside.follow(simulation);
  expect_known(aside, simulation, {0.0, 1.0});
  CrackTrack fresh;
  fresh.look(simulation);
  EXPECT_EQ(fresh.broken_bonds(), track.broken_bonds());
  EXPECT_NEAR(fresh.length(), track.length(), 1e-9 * track.length());
}

// A straight crack along an axis has the length that its energy says: G0 is that of such a cut.
TEST(CrackTrack, TheLengthIsThatOfAStraightCut) {
  Plate plate = test::bare_plate(100, 40);
  Simulation simulation(plate, test::numerics(), {1});
  Plate cut = plate;
  cut.cracks.push_back({{0.0, 0.01}, {0.05, 0.01}, Born::broken});
  const Simulation other(cut, test::numerics(), {1});
  State state = simulation.state();
  state.bonds = other.state().bonds;
  simulation.restore(std::move(state));
  CrackTrack track;
  track.look(simulation);
  // Bonds that would reach beyond both edges are missing: less than a horizon's worth each.
  EXPECT_NEAR(track.length(), 0.05, 2e-3);
  EXPECT_LT(track.length(), 0.05);
}

TEST(CrackTrack, TheSpeedIsThatOfTheWayOverItsTime) {
  Simulation simulation(test::edge_crack(24e6), coarse(), {1});
  CrackTrack track;
  EXPECT_EQ(track.speed(), 0.0);
  std::vector<double> times, places;
  while (simulation.time() < 16e-6) {
    track.follow(simulation);
    times.push_back(simulation.time());
    places.push_back(track.tip()->x());
    simulation.step();
  }
  track.follow(simulation);
  std::size_t back = times.size() - 1;
  while (places[back] > track.tip()->x() - 8e-3) --back;
  const double mean = (track.tip()->x() - places[back]) / (simulation.time() - times[back]);
  EXPECT_GT(mean, 500.0);
  EXPECT_NEAR(track.speed(), mean, 0.15 * mean);  // an arrival more or less of eight
}

// A run that waits for its turn may be stopped again before it has gone on.
TEST(CrackTrack, WhatWasRecalledIsRemembered) {
  Simulation simulation(test::edge_crack(24e6), coarse(), {1});
  CrackTrack track;
  for (int k = 0; k < 60; ++k) {
    track.follow(simulation);
    simulation.step();
  }
  track.follow(simulation);
  ASSERT_GT(track.broken_energy(), 0.0);
  const std::vector<double> memory = track.memory();
  CrackTrack later, latest;
  later.recall(memory);
  EXPECT_EQ(later.memory(), memory);
  latest.recall(later.memory());
  latest.follow(simulation);
  EXPECT_EQ(latest.memory(), memory);
}

}  // namespace
}  // namespace hackle
