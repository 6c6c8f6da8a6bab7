// SPDX-License-Identifier: MIT
// Paints every field for a state with known values, and checks the colour of a cell in the middle.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "output/picture/painting.hpp"
#include "render/colour_map.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

constexpr double exx = 4e-5, eyy = 1e-5, exy = 2e-5;  // small: s is linear in them to 1e-4
constexpr double vx = 3.0, vy = -4.0;                 // m/s
constexpr int wide = 40, tall = 24, node_i = 22,
              node_j = 13;         // a node more than a horizon from every edge
constexpr double thickness = 0.1;  // m, large enough for fringes

// Makes a plate under a uniform strain that moves as a whole.
Simulation strained() {
  Simulation simulation(test::bare_plate(wide, tall), test::numerics(), {1});
  const double unit = simulation.dt() / simulation.lattice().grid.dx;
  State state = test::displaced(simulation, [](const Vec2& x) {
    return Vec2(exx * x.x() + exy * x.y(), exy * x.x() + eyy * x.y());
  });
  for (int row = 0; row < tall; ++row)
    for (int column = 0; column < wide; ++column) state.set_v(column, row, unit * Vec2(vx, vy));
  simulation.restore(std::move(state));
  return simulation;
}

// Returns the value of each field at the node, by closed forms.
std::map<std::string, double> expected(const Simulation& simulation) {
  const Lattice& lattice = simulation.lattice();
  const auto [C11, C12, E, nu, zener] = lattice.calibration.moduli;
  const Vec2 place = lattice.grid.dx * lattice.grid.from_centre(node_i, node_j);
  const Vec2 u(exx * place.x() + exy * place.y(), exy * place.x() + eyy * place.y());
  const double sxx = C11 * exx + C12 * eyy, syy = C12 * exx + C11 * eyy, sxy = 2.0 * C12 * exy;
  const double shear = std::hypot(0.5 * (sxx - syy), sxy), mean = 0.5 * (sxx + syy);
  // The most stretched bond of the family: s = e . E . e for its direction.
  double max = 0.0;
  lattice.family.for_each_bond([&](int, int, const Vec2& xi, double, int) {
    const Vec2 e = xi.normalized();
    max = std::max(max, exx * e.x() * e.x() + eyy * e.y() * e.y() + 2.0 * exy * e.x() * e.y());
  });
  return {{"damage", 0.0},
          {"displacement", u.norm()},
          {"displacement_x", u.x()},
          {"displacement_y", u.y()},
          {"speed", 5.0},
          {"velocity_x", vx},
          {"velocity_y", vy},
          {"stretch", max / lattice.calibration.s0},
          {"energy_density", 0.5 * (sxx * exx + syy * eyy + 2.0 * sxy * exy)},
          {"stress_xx", sxx},
          {"stress_yy", syy},
          {"stress_xy", sxy},
          {"stress_1", mean + shear},
          {"stress_2", mean - shear},
          {"stress_mean", 0.5 * (sxx + syy)},
          {"von_mises", std::sqrt(sxx * sxx - sxx * syy + syy * syy + 3.0 * sxy * sxy)},
          {"shear", shear},
          {"fringes", 2.0 * shear * thickness / simulation.plate().material.fringe},
          {"fragments", 1.0},
          {"strength", 1.0},
          {"temperature", 0.0}};
}

// Interpolates between entries of a map.
std::array<double, 3> colour_at(const ColourMap& map, double share) {
  const double place = share * static_cast<double>(map.colours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), map.colours.size() - 2);
  const Colour one = map.colours[below], other = map.colours[below + 1];
  const double t = place - static_cast<double>(below);
  return {one.red + t * (other.red - one.red), one.green + t * (other.green - one.green),
          one.blue + t * (other.blue - one.blue)};
}

// A third of the range lies below the value, so that it is not clamped.
Ends ends_around(double value) {
  const double size = value == 0.0 ? 1.0 : std::abs(value);
  return {value - size / 3.0, value + 2.0 * size / 3.0};
}

class FieldPicture : public testing::TestWithParam<std::string_view> {};

TEST_P(FieldPicture, ShowsItsValueInTheColourOfTheMap) {
  const Simulation simulation = strained();
  PictureOptions options;
  options.field = GetParam();
  options.thickness = thickness;
  options.scale = Scale::linear;
  const double value = expected(simulation).at(options.field);
  options.range = ends_around(value);
  const PictureStyle style = style_of(options, simulation);
  const Image image = paint(simulation, options);
  const Rectangle plate = layout_of(style).plate;
  const int x = plate.x + static_cast<int>((node_i + 0.5) / wide * plate.width);
  const int y = plate.bottom() - 1 - static_cast<int>((node_j + 0.5) / tall * plate.height);
  const auto* pixel = &image.pixels[static_cast<std::size_t>(y * image.stride() + 4 * x)];
  const ColourMap map = style.field.colour_map == fringes_name
                            ? fringe_map(style.field.min, style.field.max)
                            : load_colour_map(style.field.colour_map);
  const std::array<double, 3> colour = colour_at(map, 1.0 / 3.0);
  // The value is exact to 1e-3, which is a fourth of an entry of the map; maps change by at most 4
  // levels from entry to entry, and rounding adds one.
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(pixel[2 - k], colour[k], 2.0) << k;
}

INSTANTIATE_TEST_SUITE_P(Fields, FieldPicture, testing::ValuesIn(scalar_names),
                         [](const auto& of) { return std::string(of.param); });

}  // namespace
}  // namespace hackle
