// SPDX-License-Identifier: MIT
#include "lattice/grid.hpp"

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

TEST(Grid, ThePapersPlateHasSixteenThousandNodes) {
  const Grid grid = make_grid(test::edge_crack(0.0), 0.5e-3);
  EXPECT_EQ(grid.nx, 200);
  EXPECT_EQ(grid.ny, 80);
  EXPECT_EQ(grid.nodes(), 16000U);
  EXPECT_NEAR(grid.position(0, 0).x(), 0.25e-3, 1e-16);
  EXPECT_NEAR(grid.position(199, 79).y(), 39.75e-3, 1e-16);
}

TEST(Grid, MirrorImagesAreExactlyOppositeFromTheCentre) {
  for (const int nx : {1, 2, 7, 200}) {
    Grid grid{nx, nx + 1, 0.3e-3, {0.01, 0.02}};
    for (int i = 0; i < grid.nx; ++i)
      for (int j = 0; j < grid.ny; ++j)
        EXPECT_EQ(grid.from_centre(i, j), -grid.from_centre(grid.nx - 1 - i, grid.ny - 1 - j));
  }
}

TEST(Grid, APlateThatIsNoWholeNumberOfCellsIsRoundedAndCentred) {
  Plate plate = test::bare_plate(10, 10);
  plate.width = 10.4e-3;
  const Grid grid = make_grid(plate, 1e-3);
  EXPECT_EQ(grid.nx, 10);
  EXPECT_DOUBLE_EQ(grid.position(0, 0).x() + grid.position(9, 0).x(), plate.width);
}

}  // namespace
}  // namespace hackle
