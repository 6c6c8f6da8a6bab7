// SPDX-License-Identifier: MIT
// Loads along rims and on the faces of cracks, at rest, and graded materials.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "scene/grading.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

constexpr double pitch = 0.5e-3;  // spacing
constexpr int neighbours = 3;     // horizon in spacings

Numerics rim_numerics() {
  return test::numerics(pitch, neighbours * pitch);
}

// A crack of half length a under a pressure p opens by 4 p a/E in the middle (Sneddon 1946), in a
// strip of half width b by as much times V(a/b) (Tada, Paris and Irwin, The Stress Analysis of
// Cracks Handbook, section 2.1: 0.6 %). `columns` is that of the plate, a twentieth of which is a.
// The faces have a soft skin of a horizon (src/lattice/README.md 5.5), which opens them by a share
// of horizon over a more.
double opening_over_sneddon(int columns) {
  Plate plate = test::bare_plate(columns, columns);
  const double a = 0.05 * plate.width, pressure = 1e6;
  const Vec2 middle(0.5 * plate.width, 0.5 * plate.height);
  Crack crack(middle - Vec2(a, 0.0), middle + Vec2(a, 0.0));
  crack.name = "slit";
  plate.cracks = {crack};
  plate.loads.pressures = {{"slit", pressure, {}}};
  Simulation simulation(plate, rim_numerics(), {2});
  simulation.relax();
  const int i = columns / 2, j = columns / 2;
  double opening = 0.0;
  for (const int column : {i - 1, i})
    opening +=
        0.5 * (simulation.displacement(column, j) - simulation.displacement(column, j - 1)).y();
  const double part = 0.1;
  const double wide = -0.071 - 0.535 * part + 0.169 * part * part + 0.02 * std::pow(part, 3) -
                      1.071 / part * std::log(1.0 - part);
  return opening / (4.0 * pressure * a / simulation.lattice().calibration.moduli.E * wide);
}

TEST(Sneddon, APressureOpensACrackByItsClosedForm) {
  const double coarse = opening_over_sneddon(200), fine = opening_over_sneddon(400);
  RecordProperty("coarse", std::to_string(coarse));
  RecordProperty("fine", std::to_string(fine));
  EXPECT_NEAR(coarse, 1.0, 0.10);
  EXPECT_NEAR(fine, 1.0, 0.07);
  EXPECT_LT(std::abs(fine - 1.0), 0.7 * std::abs(coarse - 1.0));
}

// A disc under a pressure p on two opposite arcs of half angle alpha is pulled apart across them by
// 2p/pi (sin 2 alpha - alpha) in its middle, and pressed along them by 2p/pi (sin 2 alpha + alpha)
// (Hondros 1959).
TEST(Brazilian, TheMiddleOfADiscIsPulledApart) {
  constexpr int columns = 120;
  constexpr double alpha = 10.0 * std::numbers::pi / 180.0, p = 1e6;
  Plate plate = test::bare_plate(columns, columns);
  const double radius = 0.5 * plate.width;
  plate.outlines = {{{Ellipse{{radius, radius}, {radius, radius}, 0.0}}, "rim"}};
  const double up = 0.5 * std::numbers::pi;
  plate.loads.pressures = {{"rim", p, {}, Vec2(up - alpha, up + alpha)},
                           {"rim", p, {}, Vec2(-up - alpha, -up + alpha)}};
  Simulation simulation(plate, rim_numerics(), {2});
  simulation.relax();
  const Moduli moduli = simulation.lattice().calibration.moduli;
  constexpr int i = columns / 2, reach = 4;
  const auto u = [&](int column, int row) { return simulation.displacement(column, row); };
  const double ex = (u(i + reach - 1, i) - u(i - reach, i)).x() / ((2 * reach - 1) * pitch);
  const double ey = (u(i, i + reach - 1) - u(i, i - reach)).y() / ((2 * reach - 1) * pitch);
  const double across = moduli.C11 * ex + moduli.C12 * ey;
  const double along = moduli.C11 * ey + moduli.C12 * ex;
  const double unit = 2.0 * p / std::numbers::pi;
  EXPECT_NEAR(across / (unit * (std::sin(2.0 * alpha) - alpha)), 1.0, 0.04);
  EXPECT_NEAR(along / (-unit * (std::sin(2.0 * alpha) + alpha)), 1.0, 0.04);
}

// A bar whose modulus grows from E to 2 E along it is stretched by ln 2 of what it would be at E.
// Both bars have the same soft skin.
TEST(Graded, ABarIsStretchedByTheLogarithm) {
  const auto stretched = [](bool graded) {
    Plate plate = test::bare_plate(120, 24);
    const double length = plate.width;
    Grading grading{plate.material};
    grading.fields[0] = ScalarField(std::function<double(const Vec2&)>(
        [=](const Vec2& at) { return 65e9 * (1.0 + at.x() / length); }));
    grading.levels = 30;
    if (graded) plate.inclusions = make(plate, grading);
    plate.loads.tractions.push_back({Edge::left, {-1e5, 0.0}});
    plate.loads.tractions.push_back({Edge::right, {1e5, 0.0}});
    Simulation simulation(plate, rim_numerics(), {2});
    simulation.relax();
    return (simulation.displacement(119, 12) - simulation.displacement(0, 12)).x();
  };
  EXPECT_NEAR(stretched(true) / stretched(false), std::numbers::ln2, 0.01);
}

}  // namespace
}  // namespace hackle
