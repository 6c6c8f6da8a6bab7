// SPDX-License-Identifier: MIT
#include "measure/view_difference.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

class ViewDifference : public testing::Test {
 protected:
  const FieldDifference& field(const std::vector<FieldDifference>& list, const char* name) const {
    for (const FieldDifference& one : list)
      if (one.name == name) return one;
    throw std::out_of_range(name);
  }

  Simulation one_{test::edge_crack(12e6), test::numerics(2e-3, 6e-3), {1}};
  Simulation other_ = one_;
};

TEST_F(ViewDifference, OfOneStateIsNone) {
  one_.run(5e-6);
  other_.run(5e-6);
  for (const FieldDifference& found : differences(one_, other_, Compared::in_double))
    EXPECT_TRUE(found.is_none()) << found.name;
}

TEST_F(ViewDifference, IsWhereAndAsLargeAsOneNodeWasMoved) {
  State state = one_.state();
  state.set_u(7, 3, {3e-3, 4e-3});  // in spacings
  other_.restore(state);
  const auto found = field(differences(one_, other_, Compared::in_double), "displacement");
  const double length = 5e-3 * one_.lattice().grid.dx;
  EXPECT_DOUBLE_EQ(found.max, length);
  EXPECT_EQ(found.i, 7);
  EXPECT_EQ(found.j, 3);
  EXPECT_DOUBLE_EQ(found.l2, length / std::sqrt(one_.lattice().grid.nodes()));
}

TEST_F(ViewDifference, InSinglePrecisionHidesWhatAFloatCannotHold) {
  State state = one_.state();
  state.set_u(7, 3, {1.0, 0.0});
  one_.restore(state);
  state.set_u(7, 3, {1.0 + 1e-12, 0.0});
  other_.restore(state);
  EXPECT_TRUE(field(differences(one_, other_, Compared::in_single), "displacement").is_none());
  EXPECT_FALSE(field(differences(one_, other_, Compared::in_double), "displacement").is_none());
}

// A broken bond is one bit of the node that keeps it, and damage of both its ends.
TEST_F(ViewDifference, CountsBondsWhereTheyAreKept) {
  State state = one_.state();
  state.bonds.clear(state.layout.at(20, 5), 0);
  other_.restore(state);
  const auto list = differences(one_, other_, Compared::in_double);
  EXPECT_EQ(field(list, "bonds").max, 1.0);
  EXPECT_EQ(field(list, "bonds").i, 20);
  EXPECT_EQ(field(list, "bonds").j, 5);
  EXPECT_NEAR(field(list, "damage").max, 1.0 / one_.lattice().family.bonds(), 1e-6);
}

TEST_F(ViewDifference, SeesBodiesOnlyWhereThereAreSome) {
  EXPECT_EQ(differences(one_, other_, Compared::in_double).size(), 4U);
  Plate plate = test::bare_plate(40, 20);
  plate.loads.impactors.push_back({{-6e-3, 5e-3}, 4e-3, {80.0, 0.0}, 0.5});
  Simulation near(plate, test::numerics(), {1}), far = near;
  far.run(1e-6);
  const auto found = field(differences(near, far, Compared::in_double), "bodies");
  EXPECT_NEAR(found.max, 80e-6, 1e-9);
  EXPECT_EQ(found.i, -1);
}

}  // namespace
}  // namespace hackle
