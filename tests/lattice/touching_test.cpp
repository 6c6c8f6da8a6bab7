// SPDX-License-Identifier: MIT
#include "lattice/touching.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "lattice/lattice.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

constexpr double spacing = 0.5e-3;

Impactor disc(double speed) {
  return {{-2e-3, 2e-3}, 2e-3, {speed, 0.0}, 0.1};
}

TEST(Touching, CountsContactsAndTheDiscsThatMeet) {
  Plate plate = test::bare_plate(20, 10);
  EXPECT_EQ(touching_of(plate, spacing).nodes, 0.0);
  EXPECT_EQ(touching_of(plate, spacing).bonds, 1.0);
  const double recoil = 2.0 * 2e-3 * spacing * 2235.0 / 0.1;
  for (int discs = 1; discs <= 3; ++discs) {
    plate.loads.impactors.push_back(disc(1.0));
    EXPECT_DOUBLE_EQ(touching_of(plate, spacing).nodes, discs * 15.0 * (1.0 + recoil));
  }
  for (std::size_t k = 0; k < 3; ++k) plate.loads.impactors[k].centre.y() += 0.1 * double(k);
  EXPECT_DOUBLE_EQ(touching_of(plate, spacing).nodes, 2.0 * 15.0 * (1.0 + recoil));
  plate.loads.impactors[1].velocity.y() = -0.1 / 0.05;  // they meet after 50 ms
  plate.loads.impactors[2].velocity.y() = -0.2 / 0.05;
  EXPECT_DOUBLE_EQ(touching_of(plate, spacing).nodes, 3.0 * 15.0 * (1.0 + recoil));
  plate.loads.impactors.clear();
  plate.contact = Contact{20.0, 0.9};
  EXPECT_DOUBLE_EQ(touching_of(plate, spacing).nodes, 80.0);
  EXPECT_EQ(touching_of(plate, spacing).bonds, faces_bear);
  plate.loads.impactors.push_back(disc(1.0));
  EXPECT_DOUBLE_EQ(touching_of(plate, spacing).nodes, 80.0 + 20.0 * (1.0 + recoil));
}

TEST(Touching, LowersTheLimitOfTheLattice) {
  Plate plate = test::bare_plate(20, 10);
  const Lattice alone(plate, test::numerics());
  plate.loads.impactors.push_back(disc(1.0));
  const Lattice hit(plate, test::numerics());
  EXPECT_LT(hit.step_limit, alone.step_limit);
  EXPECT_EQ(step_limit(alone, plate), hit.step_limit);
}

// A held body adds its stiffness; one that a force leads also recoils: 5 mm of nodes against 0.01
// kg/m.
TEST(Touching, CountsRollersAndPlatens) {
  Plate plate = test::bare_plate(20, 10);
  plate.loads.platens.push_back({{0.0, 5e-3}, {5e-3, 6e-3}, {}});
  EXPECT_DOUBLE_EQ(touching_of(plate, spacing).nodes, 15.0);
  Guided& guided = plate.loads.platens.front().guided;
  guided.guide = Guide::force;
  guided.mass = 0.01;
  EXPECT_DOUBLE_EQ(touching_of(plate, spacing).nodes,
                   15.0 * (1.0 + 5e-3 * spacing * 2235.0 / 0.01));
  plate.loads.rollers.assign(2, {{5e-3, 8e-3}, 2e-3, {}});
  EXPECT_DOUBLE_EQ(touching_of(plate, spacing).nodes,
                   30.0 * (1.0 + 5e-3 * spacing * 2235.0 / 0.01));
}

// By its largest speed: of a velocity at its largest factor, of a displacement where it is
// steepest, 2 m/s * 3 and 1 mm in 10 us.
TEST(Touching, RollersAndPlatensMayCrossATenthOfASpacingInAStep) {
  Plate plate = test::bare_plate(20, 10);
  plate.loads.rollers.push_back({{5e-3, 8e-3}, 2e-3, {Guide::velocity, {0, -2}}});
  plate.loads.rollers.front().guided.amplitude = Amplitude({{0.0, 1.0}, {1e-6, -3.0}});
  EXPECT_DOUBLE_EQ(longest_step_of_bodies(plate, spacing).longest, 0.1 * spacing / 6.0);
  EXPECT_EQ(longest_step_of_bodies(plate, spacing).who, "roller");
  plate.loads.platens.push_back({{0, 6e-3}, {5e-3, 7e-3}, {Guide::displacement, {0, -1e-3}}});
  plate.loads.platens.front().guided.amplitude = ramp(10e-6);
  EXPECT_DOUBLE_EQ(longest_step_of_bodies(plate, spacing).longest, 0.1 * spacing / 100.0);
  EXPECT_EQ(longest_step_of_bodies(plate, spacing).who, "platen");
}

TEST(Touching, ADiscMayCrossATenthOfASpacingInAStep) {
  Plate plate = test::bare_plate(20, 10);
  EXPECT_EQ(longest_step_of_bodies(plate, spacing).longest,
            std::numeric_limits<double>::infinity());
  plate.loads.impactors = {disc(100.0), disc(-1000.0)};
  EXPECT_DOUBLE_EQ(longest_step_of_bodies(plate, spacing).longest, 50e-9);
  plate.initial_conditions.push_back({{}, Vec2(0, 0), Vec2(1000.0, 0.0)});  // head on
  EXPECT_DOUBLE_EQ(longest_step_of_bodies(plate, spacing).longest, 25e-9);
}

}  // namespace
}  // namespace hackle
