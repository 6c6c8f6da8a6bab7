// SPDX-License-Identifier: MIT
#include "output/report/shape_remarks.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "output/picture/painting.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> remarks_of(const Plate& plate) {
  return shape_remarks(plate, Lattice(plate, test::numerics()));
}

// A node of the plate lies at 5.25 mm.
Plate cut(const Shape& shape, const std::string& name = "") {
  Plate plate = test::bare_plate(40, 20);
  plate.cutouts.push_back({shape, name});
  return plate;
}

TEST(ShapeRemarks, AreSilentForAnOrdinaryHole) {
  EXPECT_THAT(remarks_of(cut(rectangle({4e-3, 4e-3}, {8e-3, 8e-3}))), IsEmpty());
  EXPECT_THAT(remarks_of(test::bare_plate(40, 20)), IsEmpty());
}

TEST(ShapeRemarks, TellOfANotchThatIsThinnerThanTheSpacing) {
  EXPECT_THAT(remarks_of(cut(rectangle({4.9e-3, 0.0}, {5.1e-3, 5e-3}), "slit")),
              ElementsAre(HasSubstr("cut-out 1 'slit' (polygon) is thinner than the spacing of 0.5 "
                                    "mm: it removes no node and works as a crack")));
}

// A hole in the corner beyond the outermost nodes.
TEST(ShapeRemarks, TellOfAHoleThatNoBondMeets) {
  EXPECT_THAT(remarks_of(cut(rectangle({0.05e-3, 0.05e-3}, {0.1e-3, 0.1e-3}))),
              ElementsAre(HasSubstr("so small that it changes nothing at a spacing of 0.5 mm")));
}

TEST(ShapeRemarks, TellOfAnInclusionWithoutANode) {
  Plate plate = test::bare_plate(40, 20);
  Material steel = test::duran50();
  steel.E = 200e9;
  plate.inclusions.push_back({rectangle({5e-3, 5e-3}, {5.1e-3, 5.1e-3}), steel});
  EXPECT_THAT(remarks_of(plate),
              ElementsAre(HasSubstr("inclusion 1 covers no node at a spacing of 0.5 mm")));
}

// A node enclosed by four slits along the borders of its cell, which end in the neighbouring cells.
TEST(ShapeRemarks, TellOfNodesWithoutABond) {
  Plate plate = test::bare_plate(40, 20);
  const double a = 4.9e-3, b = 5.1e-3, c = 5.4e-3, d = 5.6e-3;
  for (const Shape& slit : {rectangle({a, a}, {b, d}), rectangle({c, a}, {d, d}),
                            rectangle({a, a}, {d, b}), rectangle({a, c}, {d, d})})
    plate.cutouts.push_back({slit, ""});
  EXPECT_THAT(remarks_of(plate), testing::Contains(HasSubstr("1 node is left without any bond")));
}

// Cut-outs have no damage to show.
TEST(Painting, LeavesOutWhatIsCutOut) {
  const Simulation simulation(cut(rectangle({4e-3, 4e-3}, {8e-3, 8e-3})), test::numerics(), {1});
  const Shot shot = shot_of({}, simulation);
  const Lattice& lattice = simulation.lattice();
  int left_out = 0;
  for (int j = 0; j < lattice.grid.ny; ++j)
    for (int i = 0; i < lattice.grid.nx; ++i) {
      const bool nothing = std::isnan(shot.values[lattice.grid.index(i, j)]);
      EXPECT_EQ(nothing, lattice.is_void(i, j)) << i << "," << j;
      left_out += nothing ? 1 : 0;
    }
  EXPECT_EQ(left_out, 64);
}

}  // namespace
}  // namespace hackle
