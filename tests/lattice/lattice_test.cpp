// SPDX-License-Identifier: MIT
#include "lattice/lattice.hpp"

#include <numeric>
#include <optional>

#include <gtest/gtest.h>

#include "support/composite.hpp"

namespace hackle {
namespace {

TEST(Lattice, CountsTheBondsOfARectangle) {
  // An offset (a, b) occurs (nx - |a|)(ny - |b|) times.
  const Lattice lattice(test::bare_plate(200, 80), test::numerics());
  std::int64_t expected = 0;
  lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int) {
    expected += (200 - std::abs(a)) * (80 - std::abs(b));
  });
  EXPECT_EQ(lattice.initial_bonds(), expected);
  EXPECT_EQ(lattice.bonds.count(), expected);
}

TEST(Lattice, NoFailZonesCoverTheirNodesAndTheBondsThatReachIn) {
  Plate plate = test::bare_plate(20, 20);
  plate.no_fail.push_back(strip(plate, Edge::top, 1e-3));  // the two top rows
  const Lattice lattice(plate, test::numerics());
  lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i) {
        const bool inside = lattice.grid.contains(i + a, j + b);
        EXPECT_EQ(lattice.unbreakable.holds(lattice.grid.layout().at(i, j), bit),
                  inside && (j >= 18 || j + b >= 18));
      }
  });
}

TEST(Lattice, DegreesCountBothEndsOfEveryBond) {
  const Lattice lattice(test::bare_plate(23, 11), test::numerics());
  const auto degree = degrees(lattice.grid, lattice.family, lattice.bonds);
  EXPECT_EQ(degree[lattice.grid.index(11, 5)], 48);
  EXPECT_EQ(degree[lattice.grid.index(0, 0)], 4 + 4 + 8);  // a quarter: two half axes, eight quads
  EXPECT_EQ(std::accumulate(degree.begin(), degree.end(), std::int64_t{0}),
            2 * lattice.bonds.count());
}

TEST(Lattice, AnIsolatedNodeHasNoBonds) {
  const Lattice lattice(test::bare_plate(20, 20), test::numerics());
  BondBits bonds = lattice.bonds;
  isolate(lattice.grid, lattice.family, 7, 9, bonds);
  const auto degree = degrees(lattice.grid, lattice.family, bonds);
  EXPECT_EQ(degree[lattice.grid.index(7, 9)], 0);
  EXPECT_EQ(degree[lattice.grid.index(8, 9)], 47);
  EXPECT_EQ(lattice.bonds.count() - bonds.count(), 48);
}

TEST(Lattice, WithoutNoFailZonesNothingIsStoredForThem) {
  EXPECT_TRUE(Lattice(test::bare_plate(20, 20), test::numerics()).unbreakable.empty());
}

// As a plate of that material alone would, whatever its position in the list.
TEST(Lattice, CalibratesEveryMaterialAsAPlateOfIt) {
  for (const Plane plane : {Plane::stress, Plane::strain})
    for (const Constants constants : {Constants::lattice, Constants::continuum}) {
      Plate plate = test::bare_plate(30, 20);
      plate.plane = plane;
      Numerics numerics = test::numerics();
      numerics.constants = constants;
      numerics.quadrature = Quadrature::area;
      const Material others[] = {test::resin(), test::steel()};
      plate.inclusions.push_back({rectangle({0, 0}, {5e-3, 5e-3}), others[0]});
      plate.inclusions.push_back({rectangle({0, 5e-3}, {5e-3, 10e-3}), others[1]});
      const Lattice mixed(plate, numerics);
      ASSERT_EQ(mixed.materials.size(), 3U);
      for (std::size_t k = 0; k < 2; ++k) {
        Plate pure = test::bare_plate(30, 20);
        pure.plane = plane;
        pure.material = others[k];
        const Calibration wanted = Lattice(pure, numerics).calibration;
        EXPECT_EQ(mixed.materials[k + 1].material, others[k]);
        EXPECT_EQ(mixed.materials[k + 1].calibration.c, wanted.c);
        EXPECT_EQ(mixed.materials[k + 1].calibration.s0, wanted.s0);
        EXPECT_EQ(mixed.materials[k + 1].calibration.moduli.E, wanted.moduli.E);
        EXPECT_EQ(mixed.micromodulus_at(2, k == 0 ? 2 : 15), wanted.c);
        EXPECT_EQ(mixed.critical_stretch_at(2, k == 0 ? 2 : 15), wanted.s0);
      }
    }
}

TEST(Lattice, TheLastInclusionCoversAndACutOutTakesAll) {
  Plate plate = test::bare_plate(30, 20);
  plate.inclusions.push_back({rectangle({0, 0}, {5e-3, 10e-3}), test::resin()});
  plate.inclusions.push_back({rectangle({0, 0}, {5e-3, 5e-3}), test::steel()});
  plate.cutouts.push_back({rectangle({0, 0}, {1e-3, 1e-3}), ""});
  const Lattice lattice(plate, test::numerics());
  EXPECT_EQ(lattice.material_at(5, 15).material.name, "resin");
  EXPECT_EQ(lattice.material_at(5, 5).material.name, "steel");
  EXPECT_EQ(lattice.material_at(15, 5).material.name, plate.material.name);
  EXPECT_TRUE(lattice.is_void(1, 1));
  EXPECT_EQ(lattice.micromodulus_at(1, 1), lattice.calibration.c);
}

TEST(Lattice, IsMixedByEveryPropertyOfBonds) {
  const auto with = [](auto change) {
    Plate plate = test::bare_plate(20, 20);
    Material other = plate.material;
    change(other);
    plate.inclusions.push_back({rectangle({0, 0}, {5e-3, 5e-3}), other});
    return Lattice(plate, test::numerics());
  };
  EXPECT_FALSE(with([](Material& m) { m.name = "twin"; }).is_mixed());
  EXPECT_TRUE(with([](Material& m) { m.E *= 2.0; }).is_mixed());
  EXPECT_TRUE(with([](Material& m) { m.rho *= 2.0; }).is_mixed());
  EXPECT_TRUE(with([](Material& m) { m.G0 *= 2.0; }).is_mixed());
  EXPECT_TRUE(with([](Material& m) { m.alpha = 0.2; }).is_mixed());
  EXPECT_TRUE(with([](Material& m) { m.alpha = 0.2; }).has_history());
  EXPECT_FALSE(with([](Material& m) { m.E *= 2.0; }).has_history());
  const Lattice weak = with([](Material& m) { m.G0 *= 0.25; });
  EXPECT_DOUBLE_EQ(weak.min_stretch(), 0.5 * weak.calibration.s0);
  const Lattice strong = with([](Material& m) { m.G0 *= 4.0; });
  EXPECT_DOUBLE_EQ(strong.min_stretch(), strong.calibration.s0);
}

TEST(Lattice, StrengthScalesTheCriticalStretchOfItsNode) {
  Plate plate = test::bare_plate(20, 20);
  plate.inclusions.push_back({rectangle({0, 0}, {5e-3, 10e-3}), test::steel()});
  plate.scatter = Scatter{Scatter::Kind::normal, 0.2, 0.0, 3};
  const Lattice lattice(plate, test::numerics());
  for (const auto& [i, j] : {std::pair{3, 4}, {4, 3}, {15, 7}, {7, 15}}) {
    const double s0 = lattice.materials[i < 10 ? 1 : 0].calibration.s0;
    const double factor = lattice.strength[static_cast<std::size_t>(j * 20 + i)];
    EXPECT_DOUBLE_EQ(lattice.critical_stretch_at(i, j), s0 * factor);
  }
}

// Bonds cut by a crack are damage, or never existed.
TEST(Lattice, ACrackIsBornAsItSays) {
  const auto with = [](Born born) {
    Plate plate = test::bare_plate(20, 20);
    plate.cracks.push_back({{5e-3, 0.0}, {5e-3, 10e-3}, born});
    return Lattice(plate, test::numerics());
  };
  const Lattice whole(test::bare_plate(20, 20), test::numerics());
  const Lattice broken = with(Born::broken), absent = with(Born::absent);
  EXPECT_EQ(broken.bonds.count(), absent.bonds.count());
  EXPECT_LT(broken.bonds.count(), whole.bonds.count());
  EXPECT_EQ(broken.initial_bonds(), whole.bonds.count());
  EXPECT_EQ(absent.initial_bonds(), absent.bonds.count());
}

// The limit combines the stiffest and the lightest material in any position; contacts stiffen it.
TEST(Lattice, ItsStepLimitIsThatOfTheWorstThatItHas) {
  const auto with = [](std::vector<Material> list, std::optional<Contact> contact = {}) {
    Plate plate = test::bare_plate(30, 20);
    plate.contact = contact;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const double left = 2e-3 * static_cast<double>(k);
      plate.inclusions.push_back({rectangle({left, 0}, {left + 2e-3, 10e-3}), list[k]});
    }
    return Lattice(plate, test::numerics()).step_limit;
  };
  Plate worst = test::bare_plate(30, 20);
  worst.material = test::steel();
  worst.material.rho = test::resin().rho;
  const double wanted = Lattice(worst, test::numerics()).step_limit;
  EXPECT_DOUBLE_EQ(with({test::steel(), test::resin()}), wanted);
  EXPECT_DOUBLE_EQ(with({test::resin(), test::steel()}), wanted);
  EXPECT_GT(with({}), wanted);
  EXPECT_LT(with({}, Contact{}), with({}));
  EXPECT_LT(with({}, Contact{30.0, 0.9}), with({}, Contact{15.0, 0.9}));
}

}  // namespace
}  // namespace hackle
