// SPDX-License-Identifier: MIT
// Closed forms of bodies that are thin against the horizon, without and with the correction of
// surfaces (src/lattice/README.md 3.9). Each is solved at two spacings; with surface = "energy" the
// error is at most a third, and falls. Measured errors: table in src/lattice/README.md 3.10.
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

constexpr double height = 10e-3;  // of bars, m
constexpr double load = 1e4;      // Pa: strains of 1e-7

Numerics bar_numerics(int rows, Surface surface) {
  Numerics numerics = test::numerics(height / rows, 3.0 * height / rows);
  numerics.surface = surface;
  return numerics;
}

Plate bar_of(double length) {
  Plate plate;
  plate.width = length;
  plate.height = height;
  plate.material = test::duran50();
  return plate;
}

// Returns the mean displacement of the two rows at mid-height, of the column of nodes at x or right
// of it.
Vec2 middle_at(const Simulation& simulation, int i) {
  const int j = simulation.lattice().grid.ny / 2;
  return 0.5 * (simulation.displacement(i, j) + simulation.displacement(i, j - 1));
}

// Returns E of a bar of `rows` rows, ten times as long, between its quarters, over the material's.
double modulus_of_bar(int rows, Surface surface) {
  Plate plate = bar_of(10.0 * height);
  Support grip;
  grip.region = strip(plate, Edge::left, height / rows);
  grip.along_y = false;
  plate.loads.supports.push_back(grip);
  plate.loads.tractions.push_back({Edge::right, {load, 0.0}});
  Simulation simulation(plate, bar_numerics(rows, surface), {2});
  simulation.relax({.tolerance = 1e-9});
  const int one = 5 * rows / 2, other = 15 * rows / 2;
  const double strain = (middle_at(simulation, other) - middle_at(simulation, one)).x() /
                        ((other - one) * height / rows);
  return load / strain / plate.material.E;
}

// Returns the deflection of a cantilever, eight times as long as high, clamped over a horizon and
// pulled aside at its end, over Timoshenko's.
double deflection(int rows, Surface surface) {
  const double dx = height / rows, free = 8.0 * height;
  Plate plate = bar_of(free + 3.0 * dx);
  Support grip;
  grip.region = strip(plate, Edge::left, 3.0 * dx);
  plate.loads.supports.push_back(grip);
  plate.loads.tractions.push_back({Edge::right, {0.0, load}});
  Simulation simulation(plate, bar_numerics(rows, surface), {2});
  simulation.relax({.tolerance = 1e-9});
  const double E = plate.material.E, nu = simulation.lattice().calibration.moduli.nu;
  const double length = free - 0.5 * dx;  // the traction acts on the last column of nodes
  const double force = load * height, I = std::pow(height, 3) / 12.0;
  const double wanted = force * std::pow(length, 3) / (3.0 * E * I) +
                        1.2 * force * length / (E / (2.0 * (1.0 + nu)) * height);
  return middle_at(simulation, simulation.lattice().grid.nx - 1).y() / wanted;
}

// Returns the mean radial displacement, halfway between the rims, of a ring under inner pressure,
// over Lame's, with the shear modulus of the lattice averaged over all directions: the stress of
// the ring is mostly one of shear, and lattices are not quite isotropic.
double widening(int cells, Surface surface) {
  const double outer = 20e-3, inner = 10e-3, dx = outer / cells;
  Plate plate = bar_of(2.0 * outer + 2.0 * dx);
  plate.height = plate.width;
  const Vec2 centre(0.5 * plate.width, 0.5 * plate.height);
  plate.outlines.push_back({{Ellipse{centre, {outer, outer}, 0.0}}, ""});
  plate.cutouts.push_back({Ellipse{centre, {inner, inner}, 0.0}, "bore"});
  plate.loads.pressures.push_back({"bore", load, {}});
  Numerics numerics = test::numerics(dx, 4.0 * dx);
  numerics.quadrature = Quadrature::area;
  numerics.surface = surface;
  Simulation simulation(plate, numerics, {2});
  simulation.relax({.tolerance = 1e-9});
  const Moduli moduli = simulation.lattice().calibration.moduli;
  const double bulk = 0.5 * (moduli.C11 + moduli.C12);
  const double shear = 0.25 * (moduli.C11 - moduli.C12) * (1.0 + moduli.zener);
  double sum = 0.0, wanted = 0.0;
  const Grid& grid = simulation.lattice().grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const Vec2 x = grid.position(i, j) - centre;
      const double r = x.norm();
      if (std::abs(r - 0.5 * (inner + outer)) > dx) continue;
      sum += simulation.displacement(i, j).dot(x) / r;
      wanted += load * inner * inner / (outer * outer - inner * inner) *
                (0.5 * r / bulk + 0.5 * outer * outer / (shear * r));
    }
  return sum / wanted;
}

// Returns a quarter of the period of the first longitudinal mode of a free bar, six times as long
// as high, over that of Rayleigh and Love: when the ends, which start apart, stop.
double period(int rows, Surface surface) {
  const double length = 6.0 * height;
  Plate plate = bar_of(length);
  const double nu = Lattice(plate, bar_numerics(rows, surface)).calibration.moduli.nu;
  InitialCondition start;
  start.velocity = VectorField([=](const Vec2& x) {
    const double k = std::numbers::pi / length;
    return Vec2(-1e-4 * std::cos(k * x.x()),
                -1e-4 * nu * k * (x.y() - 0.5 * height) * std::sin(k * x.x()));
  });
  plate.initial_conditions.push_back(start);
  Simulation simulation(plate, bar_numerics(rows, surface), {2});
  const double speed = std::sqrt(plate.material.E / plate.material.rho);
  const double lateral = std::pow(nu * std::numbers::pi * height / length, 2) / 24.0;
  const double wanted = 0.5 * length / (speed * (1.0 - lateral));
  // The projection on the mode is A sin(omega t): its maximum is where its velocity vanishes.
  const auto swing = [&] {
    double sum = 0.0;
    const std::vector<Vec2> v = simulation.velocities();
    const Grid& grid = simulation.lattice().grid;
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        sum +=
            v[grid.index(i, j)].x() * std::cos(std::numbers::pi * grid.position(i, j).x() / length);
    return sum;
  };
  double before = swing(), now = before;
  while (now * before > 0.0 && simulation.time() < 2.0 * wanted) {
    before = now;
    simulation.step();
    now = swing();
  }
  return (simulation.time() - simulation.dt() * now / (now - before)) / wanted;
}

using Quotient = std::function<double(int, Surface)>;

void expect_a_third(const Quotient& of, int coarse, int fine) {
  const double max = std::abs(of(coarse, Surface::none) - 1.0);
  const double most_fine = std::abs(of(fine, Surface::none) - 1.0);
  const double corrected = std::abs(of(coarse, Surface::energy) - 1.0);
  const double corrected_fine = std::abs(of(fine, Surface::energy) - 1.0);
  EXPECT_LT(most_fine, max);
  EXPECT_LT(corrected, max / 3.0) << max << ", " << corrected;
  EXPECT_LT(corrected_fine, most_fine / 3.0) << most_fine << ", " << corrected_fine;
  EXPECT_LT(corrected_fine, corrected);
}

TEST(SurfaceCorrection, OfABarOfTenRowsGivesTheModulus) {
  EXPECT_LT(modulus_of_bar(10, Surface::none), 0.95);
  EXPECT_NEAR(modulus_of_bar(10, Surface::energy), 1.0, 0.01);
  expect_a_third(modulus_of_bar, 10, 20);
}

TEST(SurfaceCorrection, OfACantileverGivesItsDeflection) {
  expect_a_third(deflection, 10, 20);
}

TEST(SurfaceCorrection, OfARingGivesItsWidening) {
  expect_a_third(widening, 20, 40);
}

TEST(SurfaceCorrection, OfAFreeBarGivesItsPeriod) {
  expect_a_third(period, 10, 20);
}

// What the literature's volume method does: it stiffens along a surface as much as across, where
// nothing is stretched.
TEST(SurfaceCorrection, ByVolumeOverdoesIt) {
  EXPECT_GT(modulus_of_bar(10, Surface::volume), 1.08);
}

}  // namespace
}  // namespace hackle
