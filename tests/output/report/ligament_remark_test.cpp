// SPDX-License-Identifier: MIT
#include "output/report/ligament_remark.hpp"

#include <gmock/gmock.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// 100 x 50 mm.
Plate wide_plate() {
  return test::bare_plate(200, 100);
}

TEST(LigamentRemark, FindsTheNarrowestPart) {
  Plate plate = wide_plate();
  EXPECT_DOUBLE_EQ(narrowest(plate), 50e-3);
  plate.cutouts.push_back({Ellipse{{60e-3, 20e-3}, {5e-3, 8e-3}, 0.0}, ""});
  EXPECT_DOUBLE_EQ(narrowest(plate), 12e-3);  // below it
  plate.cutouts.push_back({rectangle({0.0, 24e-3}, {48e-3, 25e-3}), ""});
  EXPECT_DOUBLE_EQ(narrowest(plate), 7e-3);  // from the notch to the hole
  plate.cutouts.push_back({rectangle({20e-3, 45e-3}, {30e-3, 60e-3}), ""});
  EXPECT_DOUBLE_EQ(narrowest(plate), 7e-3);  // a notch from the top, far from all
  plate.outlines.push_back({{Ring{{50e-3, 25e-3}, 24e-3, 21e-3}}, ""});
  EXPECT_DOUBLE_EQ(narrowest(plate), 3e-3);
}

// Ahead of a tip, where the crack is longer than what is left: of an edge crack, aslant, of either
// tip; not of the end on the edge, nor where more is left than the crack is long.
TEST(LigamentRemark, CountsWhatACrackLeaves) {
  Plate plate = wide_plate();
  plate.cracks.push_back({{{1e-3, 40e-3}, {4e-3, 40e-3}, {7e-3, 42e-3}}, Born::broken});
  EXPECT_DOUBLE_EQ(narrowest(plate), 1e-3);
  plate.cracks.front() = {{{0.0, 25e-3}, {60e-3, 25e-3}}, Born::broken};
  EXPECT_NEAR(narrowest(plate), 40e-3, 1e-15);
  plate.cracks.push_back(
      {{{20e-3, 0.0}, {44e-3, 32e-3}}, Born::broken});  // 3 to 4; up to the edge 18 mm
  EXPECT_NEAR(narrowest(plate), 18e-3 * 1.25, 1e-15);
  plate.cracks.push_back({{{98e-3, 20e-3}, {99.5e-3, 20e-3}}, Born::broken});
  EXPECT_NEAR(narrowest(plate), 0.5e-3, 1e-15);
}

TEST(LigamentRemark, SpeaksOfPartsUnderTwentyHorizonsAlone) {
  const Numerics numerics = test::numerics();  // a horizon of 2 mm
  EXPECT_FALSE(ligament_remark(Simulation(test::bare_plate(100, 80), numerics, {1})));
  const Simulation thin(test::bare_plate(100, 20), numerics, {1});
  EXPECT_THAT(ligament_remark(thin).value_or(""),
              testing::AllOf(HasSubstr("the narrowest part is 10 mm, 5 horizons wide"),
                             HasSubstr("by about 4 % in tension"), HasSubstr("surface = ")));
}

TEST(LigamentRemark, IsSilentWhereSurfacesAreCorrected) {
  Numerics numerics = test::numerics();
  numerics.surface = Surface::volume;
  EXPECT_FALSE(ligament_remark(Simulation(test::bare_plate(100, 20), numerics, {1})));
}

}  // namespace
}  // namespace hackle
