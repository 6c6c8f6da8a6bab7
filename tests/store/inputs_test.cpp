// SPDX-License-Identifier: MIT
#include "store/inputs.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/scenes.hpp"

namespace hackle {
namespace {

TEST(Inputs, SayEverythingThatARunWasMadeFrom) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics());
  const auto json = nlohmann::json::parse(inputs_of(simulation));
  const auto& plate = json["plate"];
  EXPECT_EQ(plate["width_m"], 0.1);
  EXPECT_EQ(plate["material"]["E_Pa"], 65e9);
  EXPECT_EQ(plate["cracks"][0]["points_m"][1][0], 0.05);
  EXPECT_EQ(plate["cracks"][0]["born"], "broken");
  EXPECT_EQ(plate["tractions"][0]["edge"], "top");
  EXPECT_EQ(plate["tractions"][0]["stress_Pa"][1], 12e6);
  EXPECT_EQ(plate["no_fail"].size(), 2U);
  const auto& numerics = json["numerics"];
  EXPECT_EQ(numerics["nx"], 200);
  EXPECT_EQ(numerics["horizon_m"], 2e-3);
  EXPECT_EQ(numerics["constants"], "lattice");
  EXPECT_EQ(numerics["step_s"], simulation.dt());
  EXPECT_EQ(numerics["critical_stretch"], simulation.lattice().calibration.s0);
}

TEST(Inputs, NameEveryChoice) {
  Plate plate = test::bare_plate(20, 10);
  plate.plane = Plane::strain;
  plate.material.alpha = 0.25;
  Numerics choices = test::numerics();
  choices.quadrature = Quadrature::centroid;
  choices.micromodulus = Micromodulus::conical;
  choices.precision = Precision::f32;
  choices.breaking = Breaking::next_step;
  const auto json = nlohmann::json::parse(inputs_of(Simulation(plate, choices)));
  EXPECT_EQ(json["plate"]["plane"], "strain");
  EXPECT_EQ(json["plate"]["material"]["alpha"], 0.25);
  const auto& numerics = json["numerics"];
  EXPECT_EQ(numerics["quadrature"], "centroid");
  EXPECT_EQ(numerics["micromodulus"], "conical");
  EXPECT_EQ(numerics["precision"], "f32");
  EXPECT_EQ(numerics["breaking"], "next_step");
  EXPECT_EQ(numerics["fidelity"], 0.0);
  EXPECT_EQ(numerics["fused"], false);
}

TEST(Inputs, AreJsonWhateverBytesAMaterialIsCalled) {
  Plate plate = test::bare_plate(20, 10);
  plate.material.name = "gl\xE4s";  // Latin-1
  const auto json = nlohmann::json::parse(inputs_of(Simulation(plate, test::numerics())));
  EXPECT_EQ(json["plate"]["material"]["name"], "gl\uFFFDs");
}

}  // namespace
}  // namespace hackle
