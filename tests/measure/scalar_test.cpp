// SPDX-License-Identifier: MIT
#include "measure/scalar.hpp"

#include <cmath>
#include <map>

#include <gmock/gmock.h>

#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

Simulation loaded() {
  Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  simulation.run(3e-6);
  return simulation;
}

TEST(Scalars, HaveAFiniteValueForEveryNodeAndEndsThatDiffer) {
  const Simulation simulation = loaded();
  for (const Scalar& scalar : scalars()) {
    const Ends ends = scalar.ends(simulation);
    EXPECT_LT(ends.min, ends.max) << scalar.name;
    EXPECT_TRUE(!scalar.logarithmic || ends.min > 0.0) << scalar.name;
    const std::vector<float> values = scalar.values(simulation);
    ASSERT_EQ(values.size(), simulation.lattice().grid.nodes()) << scalar.name;
    for (const float value : values) ASSERT_TRUE(std::isfinite(value)) << scalar.name;
  }
}

// They follow from the strength of the plate's own material; an inclusion changes only those of
// temperature.
TEST(Scalars, HaveTheEndsOfTheirDefinition) {
  Plate plate = test::bare_plate(40, 24);  // 20 x 12 mm
  plate.material.alphaT = 4e-6;
  Material other = plate.material;
  other.E *= 3.0;
  other.alphaT = 1e-6;
  plate.inclusions.push_back({rectangle({0, 0}, {5e-3, 5e-3}), other});
  const Simulation simulation(plate, test::numerics(), {1});
  const std::vector<MaterialOnLattice>& materials = simulation.lattice().materials;
  const double s0 = materials[0].calibration.s0, stress = 65e9 * s0;
  const double speed = s0 * std::sqrt(materials[0].calibration.moduli.C11 / 2235.0);
  const double warm = 0.5 * materials[1].calibration.s0 / 1e-6;
  const std::map<std::string_view, Ends> wanted{
      {"damage", {0.0, 0.5}},
      {"displacement", {0.0, 0.25 * s0 * 12e-3}},
      {"displacement_x", {-0.25 * s0 * 12e-3, 0.25 * s0 * 12e-3}},
      {"displacement_y", {-0.25 * s0 * 12e-3, 0.25 * s0 * 12e-3}},
      {"speed", {0.0, 0.5 * speed}},
      {"velocity_x", {-0.5 * speed, 0.5 * speed}},
      {"velocity_y", {-0.5 * speed, 0.5 * speed}},
      {"stretch", {0.0, 1.0}},
      {"energy_density", {0.5e-4 * stress * s0, 0.5 * stress * s0}},
      {"stress_xx", {-0.5 * stress, 0.5 * stress}},
      {"stress_yy", {-0.5 * stress, 0.5 * stress}},
      {"stress_xy", {-0.5 * stress, 0.5 * stress}},
      {"stress_1", {-0.5 * stress, 0.5 * stress}},
      {"stress_2", {-0.5 * stress, 0.5 * stress}},
      {"stress_mean", {-0.5 * stress, 0.5 * stress}},
      {"von_mises", {0.0, 0.5 * stress}},
      {"shear", {0.0, 0.25 * stress}},
      {"fringes", {0.0, stress / 136.5e3}},
      {"fragments", {0.0, 12.0}},
      {"strength", {0.5, 1.5}},
      {"temperature", {-warm, warm}}};
  ASSERT_GT(0.5 * s0 / 4e-6, 1.0);
  for (const Scalar& scalar : scalars()) {
    const Ends ends = scalar.ends(simulation), right = wanted.at(scalar.name);
    EXPECT_NEAR(ends.min, right.min, 1e-12 * std::abs(right.min)) << scalar.name;
    EXPECT_NEAR(ends.max, right.max, 1e-12 * right.max) << scalar.name;
  }
}

TEST(Scalars, AreTheirDefinitionsOnAnAnalyticState) {
  Simulation simulation(test::bare_plate(12, 12), test::numerics(), {1});
  State state = test::displaced(simulation, [](const Vec2&) { return Vec2(0.3, -0.4); });
  state.set_v(5, 0, {3e-3, -4e-3});
  simulation.restore(state);
  const double dx = simulation.lattice().grid.dx, unit = dx / simulation.dt();
  const auto value = [&](const char* name, std::size_t node) {
    return static_cast<double>(scalar_of(name).values(simulation)[node]);
  };
  EXPECT_NEAR(value("displacement", 3), 0.5 * dx, 1e-7 * dx);
  EXPECT_NEAR(value("displacement_x", 3), 0.3 * dx, 1e-7 * dx);
  EXPECT_NEAR(value("displacement_y", 3), -0.4 * dx, 1e-7 * dx);
  EXPECT_NEAR(value("speed", 5), 5e-3 * unit, 1e-6 * unit);
  EXPECT_NEAR(value("velocity_x", 5), 3e-3 * unit, 1e-6 * unit);
  EXPECT_NEAR(value("velocity_y", 5), -4e-3 * unit, 1e-6 * unit);
  EXPECT_EQ(value("strength", 0), 1.0);
  EXPECT_EQ(value("temperature", 0), 0.0);
  EXPECT_EQ(value("fragments", 0), 1.0);
}

TEST(Scalars, TemperatureIsTheChangeThatWasAsked) {
  Plate plate = test::bare_plate(20, 20);
  plate.material.alphaT = 3e-6;
  plate.loads.thermal_loads.push_back({{}, -120.0, {}});
  Simulation simulation(plate, test::numerics(), {1});
  simulation.step();
  for (const float value : scalar_of("temperature").values(simulation))
    EXPECT_NEAR(value, -120.0F, 1e-3F);
}

TEST(Scalars, FringesAreTheStressDifferenceOverTheFringeValue) {
  Simulation simulation(test::bare_plate(24, 20), test::numerics(), {1});
  const double strain = 1e-6;
  simulation.restore(
      test::displaced(simulation, [&](const Vec2& x) { return Vec2(strain * x.x(), 0.0); }));
  const Lattice& lattice = simulation.lattice();
  const Moduli& moduli = lattice.calibration.moduli;
  const double wanted = (moduli.C11 - moduli.C12) * strain / simulation.plate().material.fringe;
  EXPECT_NEAR(scalar_of(fringes_name).values(simulation)[lattice.grid.index(12, 10)], wanted,
              1e-5 * wanted);
}

TEST(Scalars, FringesNeedAFringeValue) {
  Plate plate = test::bare_plate(12, 12);
  plate.material.fringe = 0.0;
  const Simulation simulation(plate, test::numerics(), {1});
  EXPECT_THROW(scalar_of(fringes_name).ends(simulation), Error);
  EXPECT_THROW(scalar_of(fringes_name).values(simulation), Error);
}

TEST(Scalars, AnUnknownNameGetsTheNearest) {
  try {
    scalar_of("sped");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean 'speed'?"));
  }
}

}  // namespace
}  // namespace hackle
