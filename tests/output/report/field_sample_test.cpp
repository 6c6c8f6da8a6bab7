// SPDX-License-Identifier: MIT
#include "output/report/field_sample.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/scenes.hpp"

namespace hackle {
namespace {

// A plate that flies with a constant velocity moves by v t everywhere.
Plate flying() {
  Plate plate = test::bare_plate(40, 20);
  plate.initial_conditions.push_back({.velocity = Vec2(3.0, -2.0)});
  return plate;
}

SampledField sampled(const Numerics& numerics, double time) {
  Simulation simulation(flying(), numerics, {.threads = 1});
  FieldSampler sampler(time);
  std::vector<Observer*> observers{&sampler};
  simulation.run(2e-6, observers);
  return sampler.field().value();
}

TEST(FieldSample, IsThatOfTheMomentBetweenSteps) {
  for (const double spacing : {0.5e-3, 1e-3})
    for (const double time : {0.0, 0.7123e-6, 1.5e-6}) {
      const SampledField field = sampled(test::numerics(spacing, 3.0 * spacing), time);
      EXPECT_EQ(field.columns, 40);
      EXPECT_EQ(field.rows, 20);
      ASSERT_EQ(field.displacements.size(), 800U);
      for (const auto& value : field.displacements) {
        ASSERT_TRUE(value.has_value());
        EXPECT_NEAR(value->x(), 3.0 * time, 1e-9 * 3e-6);
        EXPECT_NEAR(value->y(), -2.0 * time, 1e-9 * 3e-6);
      }
    }
}

TEST(FieldSample, TellsWhereThereIsNoPlate) {
  const SampledField field{
      .time = 1.0, .columns = 2, .rows = 1, .displacements = {Vec2(1.0, 2.0), std::nullopt}};
  EXPECT_EQ(to_json(field).dump(),
            R"({"time_s":1.0,"columns":2,"rows":1,"displacements_m":[[1.0,2.0],null]})");
}

}  // namespace
}  // namespace hackle
