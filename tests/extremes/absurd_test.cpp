// SPDX-License-Identifier: MIT
// Numbers that no plate has: each must end in finite results, a refusal, or a clean stop.
#include <functional>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/outcome.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using test::Outcome;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Scene {
  Plate plate;
  Numerics numerics;
};

Scene usual() {
  Scene scene{test::bare_plate(24, 18), test::numerics()};
  scene.plate.cracks.push_back({{0.0, 4.5e-3}, {4e-3, 4.5e-3}, Born::broken});
  scene.plate.loads.tractions.push_back({Edge::top, {1e6, 10e6}});
  return scene;
}

using Change = std::function<void(Scene&, double)>;
struct Quantity {
  const char* name;
  Change set;
};

const Quantity quantities[] = {
    {"width", [](Scene& s, double x) { s.plate.width = x; }},
    {"height", [](Scene& s, double x) { s.plate.height = x; }},
    {"E", [](Scene& s, double x) { s.plate.material.E = x; }},
    {"rho", [](Scene& s, double x) { s.plate.material.rho = x; }},
    {"nu", [](Scene& s, double x) { s.plate.material.nu = x; }},
    {"G0", [](Scene& s, double x) { s.plate.material.G0 = x; }},
    {"alpha", [](Scene& s, double x) { s.plate.material.alpha = x; }},
    {"crack", [](Scene& s, double x) { s.plate.cracks[0].points[1].x() = x; }},
    {"stress", [](Scene& s, double x) { s.plate.loads.tractions[0].stress = Vec2(1e6, x); }},
    {"spacing", [](Scene& s, double x) { s.numerics.spacing = x; }},
    {"horizon", [](Scene& s, double x) { s.numerics.horizon = x; }},
    {"step", [](Scene& s, double x) { s.numerics.step = x; }},
};

Outcome outcome_of(const Quantity& quantity, double value, Precision precision,
                   bool forced = false) {
  Scene scene = usual();
  scene.numerics.precision = precision;
  scene.numerics.force_step = forced;
  quantity.set(scene, value);
  return test::outcome(scene.plate, scene.numerics, 130,
                       fmt::format("{} = {:g}, {}", quantity.name, value, name_of(precision)));
}

TEST(WhatIsNoNumber, IsRefused) {
  for (const Quantity& quantity : quantities)
    for (const double value : {nan, infinity, -infinity})
      EXPECT_EQ(outcome_of(quantity, value, Precision::f64), Outcome::refused)
          << quantity.name << " = " << value;
}

TEST(WhatIsFarFromAnyPlate, EndsInNumbersARefusalOrACleanStop) {
  for (const Precision precision : {Precision::f64, Precision::f32})
    for (const Quantity& quantity : quantities)
      for (const int exponent : {-308, -200, -100, -50, -30, -20, 20, 30, 50, 100, 200, 308})
        for (const double sign : {1.0, -1.0})
          outcome_of(quantity, sign * std::pow(10.0, exponent), precision, true);
}

TEST(TwoThingsFarFromAnyPlate, EndInNumbersARefusalOrACleanStop) {
  for (const Precision precision : {Precision::f64, Precision::f32})
    for (const double E : {1e-150, 1e-3, 1e15, 1e150})
      for (const double rho : {1e-150, 1e-6, 1e8, 1e150})
        for (const double G0 : {1e-150, 1.0, 1e150})
          for (const double stress : {1e-150, 1.0, 1e150}) {
            Scene scene = usual();
            scene.numerics.precision = precision;
            scene.plate.material.E = E;
            scene.plate.material.rho = rho;
            scene.plate.material.G0 = G0;
            scene.plate.loads.tractions[0].stress = Vec2(1e6, stress);
            test::outcome(scene.plate, scene.numerics, 70,
                          fmt::format("E {:g}, rho {:g}, G0 {:g}, stress {:g}, {}", E, rho, G0,
                                      stress, name_of(precision)));
          }
}

}  // namespace
}  // namespace hackle
