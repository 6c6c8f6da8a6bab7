// SPDX-License-Identifier: MIT
#include "scene/forecast.hpp"

#include <numbers>

#include <gmock/gmock.h>

namespace hackle {
namespace {

using Verdict = Forecast::Verdict;

constexpr double horizon = 2e-3;  // m

// 100 x 40 mm of Duran 50.
Plate glass() {
  Plate plate;
  plate.width = 0.1;
  plate.height = 0.04;
  plate.material = {
      .name = "glass", .E = 65e9, .rho = 2235.0, .nu = 0.2, .G0 = 204.0, .alphaT = 3e-6};
  return plate;
}

Plate pulled(double stress) {
  Plate plate = glass();
  plate.cracks.push_back({{0.0, 0.02}, {0.05, 0.02}});
  plate.loads.tractions.push_back({Edge::top, {0.0, stress}, 0.0, {}});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, -stress}, 0.0, {}});
  return plate;
}

Forecast of(const Plate& plate, double duration = 32e-6) {
  return forecast(plate, {.end = duration}, horizon);
}

TEST(Forecast, OfAPulledCrackIsGriffiths) {
  const Forecast found = of(pulled(12e6));
  EXPECT_DOUBLE_EQ(found.stress, 24e6);
  EXPECT_DOUBLE_EQ(found.flaw, 0.05);
  EXPECT_DOUBLE_EQ(found.release_rate, 24e6 * 24e6 * std::numbers::pi * 0.05 / 65e9);
  EXPECT_DOUBLE_EQ(found.toughness, 204.0);
  EXPECT_EQ(found.verdict(), Verdict::breaks);
}

TEST(Forecast, TellsWhatLoadsTooLittleOrNotAtAll) {
  EXPECT_EQ(of(pulled(5e6)).verdict(), Verdict::may_break);
  EXPECT_EQ(of(pulled(1e6)).verdict(), Verdict::nothing_breaks);
  EXPECT_EQ(of(glass()).verdict(), Verdict::nothing_loads_it);
  EXPECT_THAT(describe(of(glass())), testing::HasSubstr("nothing can break"));
  EXPECT_THAT(describe(of(pulled(12e6))), testing::EndsWith("G0 is 204 J/m2: it should break"));
}

TEST(Forecast, LooksAtTheStrongestMomentWithinTheDuration) {
  Plate plate = pulled(12e6);
  for (Traction& load : plate.loads.tractions) load.amplitude = step_at(50e-6);
  EXPECT_EQ(of(plate, 40e-6).verdict(), Verdict::nothing_loads_it);
  EXPECT_EQ(of(plate, 60e-6).verdict(), Verdict::breaks);
  for (Traction& load : plate.loads.tractions)
    load.amplitude = pulse(1e-9, 20e-6);  // between the sampled times
  EXPECT_EQ(of(plate, 40e-6).verdict(), Verdict::breaks);
}

TEST(Forecast, LooksAtTheStrongestPlace) {
  Plate plate = pulled(0.0);
  plate.loads.tractions.front().stress =
      VectorField([](const Vec2& at) { return Vec2(0.0, at.x() > 0.09 ? 12e6 : 0.0); });
  EXPECT_DOUBLE_EQ(of(plate).stress, 24e6);
}

TEST(Forecast, KnowsEveryLoad) {
  const auto with = [](auto change) {
    Plate plate = glass();
    change(plate);
    return of(plate).stress;
  };
  const double impedance = std::sqrt(65e9 * 2235.0);
  EXPECT_DOUBLE_EQ(with([](Plate& p) { p.loads.pressures.push_back({"hole", 3e6, {}}); }), 6e6);
  EXPECT_DOUBLE_EQ(with([](Plate& p) {
                     p.loads.body_forces.push_back({{}, {1e7, 0.0}, {}});
                   }),
                   2e6);
  EXPECT_DOUBLE_EQ(with([](Plate& p) {
                     p.loads.thermal_loads.push_back({{}, -100.0, {}});
                   }),
                   2.0 * 65e9 * 3e-6 * 100.0);
  EXPECT_DOUBLE_EQ(with([](Plate& p) {
                     p.loads.impactors.push_back({{0, 0}, 1e-3, {30, 40}, 1});
                   }),
                   2.0 * impedance * 50.0);
  EXPECT_DOUBLE_EQ(with([](Plate& p) {
                     p.initial_conditions.push_back({{}, {0.0, 0.0}, {0.0, 5.0}});
                   }),
                   2.0 * impedance * 5.0);
  EXPECT_DOUBLE_EQ(
      with([](Plate& p) {
        p.loads.supports.push_back({{}, Support::Kind::displacement, {0.0, 4e-6}, true, true, {}});
      }),
      2.0 * 65e9 * 1e-4);
}

TEST(Forecast, OfAWholePlateHasAFlawOfTheHorizon) {
  Plate plate = pulled(12e6);
  plate.cracks.clear();
  EXPECT_DOUBLE_EQ(of(plate).flaw, horizon);
  plate.cutouts.push_back({Ellipse{{0.05, 0.02}, {5e-3, 3e-3}, 0.0}, "hole"});
  EXPECT_DOUBLE_EQ(of(plate).flaw, 5e-3);
}

TEST(Forecast, TakesTheWeakestMaterial) {
  Plate plate = pulled(5e6);
  Material weak = plate.material;
  weak.G0 = 10.0;
  plate.inclusions.push_back({Ellipse{{0.05, 0.02}, {5e-3, 3e-3}, 0.0}, weak});
  EXPECT_DOUBLE_EQ(of(plate).toughness, 10.0);
  EXPECT_EQ(of(plate).verdict(), Verdict::breaks);
}

}  // namespace
}  // namespace hackle
