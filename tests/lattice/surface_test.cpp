// SPDX-License-Identifier: MIT
// The factors of nodes near a surface, against sums over a half plane.
#include "lattice/surface.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "lattice/check_numerics.hpp"
#include "lattice/lattice.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

Numerics with_surface(Surface surface, double m = 4.0, Quadrature quadrature = Quadrature::full) {
  Numerics numerics = test::numerics(0.5e-3, m * 0.5e-3);
  numerics.surface = surface;
  numerics.quadrature = quadrature;
  return numerics;
}

float factor_at(const Lattice& lattice, int i, int j) {
  return lattice.surface[lattice.grid.index(i, j)];
}

// A crack that owns its ends.
Crack cut_along(const Vec2& from, const Vec2& to, Born born = Born::broken) {
  return {std::vector<Vec2>{from, to}, born, CrackEnds::cut};
}

// Returns the bulk's sum over that of a node `rows` away from a straight edge along x, of the
// weights or of the energies when the lattice is strained along x.
double wanted(const Family& family, Surface surface, int rows) {
  double all = 0.0, kept = 0.0;
  family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int) {
    const double along = xi.x() * a;
    const double own =
        surface == Surface::volume ? weight : weight * along * along / std::pow(xi.norm(), 3);
    all += 2.0 * own;
    kept += b <= rows ? 2.0 * own : own;
  });
  return all / kept;
}

TEST(SurfaceFactors, AreAbsentWithoutACorrection) {
  EXPECT_TRUE(Lattice(test::bare_plate(20, 20), test::numerics()).surface.empty());
}

TEST(SurfaceFactors, AreThoseOfAHalfPlaneAlongStraightEdges) {
  for (const Surface surface : {Surface::volume, Surface::energy})
    for (const Quadrature quadrature : {Quadrature::full, Quadrature::area, Quadrature::centroid})
      for (const double m : {3.0, 4.0, 5.3}) {
        const Lattice lattice(test::bare_plate(30, 40), with_surface(surface, m, quadrature));
        const int reach = lattice.family.reach();
        for (int j = 0; j < reach; ++j)
          EXPECT_NEAR(factor_at(lattice, 15, j), wanted(lattice.family, surface, j), 1e-6) << m;
        EXPECT_EQ(factor_at(lattice, 15, reach), 1.0F);
        EXPECT_EQ(factor_at(lattice, 15, 20), 1.0F);
      }
  // Literature and hand: 28 of the bonds and 17 of the node on the edge, m = 3.
  const Lattice lattice(test::bare_plate(30, 40), with_surface(Surface::volume, 3.0));
  EXPECT_FLOAT_EQ(factor_at(lattice, 15, 0), 28.0F / 17.0F);
}

// The direction along an edge is found, whatever it is: along x, y or a diagonal of the lattice.
TEST(SurfaceFactors, OfEdgesAlongOtherAxesAreAlike) {
  const Lattice lattice(test::bare_plate(40, 40), with_surface(Surface::energy));
  for (int k = 0; k < 4; ++k) EXPECT_EQ(factor_at(lattice, k, 20), factor_at(lattice, 20, k)) << k;
  Plate plate = test::bare_plate(60, 60);
  plate.cracks.push_back(cut_along({10.1e-3, 10e-3}, {20.1e-3, 20e-3}));
  const Lattice aslant(plate, with_surface(Surface::energy));
  float max = 1.0F;
  for (int i = 25; i < 35; ++i) max = std::max(max, factor_at(aslant, i, i));
  // A continuous half plane would need 2 at its rim; a row of nodes is a part of a spacing away.
  EXPECT_GT(max, 1.3F);
  EXPECT_LT(max, 1.7F);
}

TEST(SurfaceFactors, OfACrackAtTheStartAreThoseOfAnEdge) {
  for (const Born born : {Born::broken, Born::absent}) {
    Plate plate = test::bare_plate(40, 40);
    plate.cracks.push_back(cut_along({0.0, 10e-3}, {20e-3, 10e-3}, born));
    const Lattice lattice(plate, with_surface(Surface::energy));
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ(factor_at(lattice, 20, 20 + k), factor_at(lattice, 20, k)) << k;
      EXPECT_EQ(factor_at(lattice, 20, 19 - k), factor_at(lattice, 20, k)) << k;
    }
  }
}

TEST(SurfaceFactors, AreMirrorImagesToTheLastBit) {
  for (const Surface surface : {Surface::volume, Surface::energy})
    for (const int nx : {40, 41}) {
      Plate plate = test::bare_plate(nx, 31), image = plate;
      const auto mirrored = [&](const Vec2& x) { return Vec2(plate.width - x.x(), x.y()); };
      const Vec2 from(3.1e-3, 2.3e-3), to(11.7e-3, 9.2e-3), hole(14.2e-3, 4.3e-3);
      plate.cracks.push_back({from, to, Born::broken});
      image.cracks.push_back({mirrored(from), mirrored(to), Born::broken});
      plate.cutouts.push_back({Ellipse{hole, {2.3e-3, 1.6e-3}, 0.0}, ""});
      image.cutouts.push_back({Ellipse{mirrored(hole), {2.3e-3, 1.6e-3}, 0.0}, ""});
      const Numerics numerics = with_surface(surface, 4.0, Quadrature::centroid);
      const Lattice one(plate, numerics), other(image, numerics);
      for (int j = 0; j < 31; ++j)
        for (int i = 0; i < nx; ++i)
          EXPECT_EQ(factor_at(one, i, j), factor_at(other, nx - 1 - i, j)) << i << ", " << j;
    }
}

// Also of nodes that stick out and of nodes without a bond.
TEST(SurfaceFactors, LieBetweenOneAndTwo) {
  for (const Surface surface : {Surface::volume, Surface::energy})
    for (const int ny : {1, 2, 5}) {
      Plate plate = test::bare_plate(30, ny);
      plate.cracks.push_back(cut_along({5e-3, 0.0}, {5.3e-3, plate.height}));
      for (const float factor : Lattice(plate, with_surface(surface)).surface) {
        EXPECT_GE(factor, 1.0F);
        EXPECT_LE(factor, 2.0F);
      }
    }
}

TEST(SurfaceFactors, ScaleTheMicromodulusAndTheStepLimit) {
  const Plate plate = test::edge_crack(12e6);
  const Lattice plain(plate, test::numerics());
  Numerics numerics = with_surface(Surface::energy);
  const Lattice corrected(plate, numerics);
  EXPECT_DOUBLE_EQ(corrected.micromodulus_at(100, 0),
                   plain.calibration.c * static_cast<double>(factor_at(corrected, 100, 0)));
  EXPECT_EQ(corrected.micromodulus_at(150, 20), plain.calibration.c);
  EXPECT_EQ(corrected.critical_stretch_at(100, 0), plain.calibration.s0);
  EXPECT_DOUBLE_EQ(corrected.step_limit, plain.step_limit / std::sqrt(2.0));
  // The check before there is a lattice agrees.
  for (const auto& [share, problems] : {std::pair{0.999, 0U}, {1.001, 1U}}) {
    numerics.step = share * corrected.step_limit;
    Problems found;
    check(plate, numerics, 1ULL << 32, found);
    EXPECT_EQ(found.list().size(), problems) << share;
  }
}

}  // namespace
}  // namespace hackle
