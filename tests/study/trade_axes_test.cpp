// SPDX-License-Identifier: MIT
#include "study/trade_axes.hpp"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>

namespace hackle {
namespace {

SceneNumerics scene() {
  SceneNumerics scene;
  scene.spacing = 1e-3;
  scene.horizon = 4e-3;
  scene.precision = "f64";
  scene.quadrature = "full";
  scene.micromodulus = "constant";
  scene.constants = "lattice";
  scene.surface = "none";
  scene.breaking = "at_once";
  scene.safety = 0.9;
  scene.E = 65e9;
  return scene;
}

double number(const Settings& settings, const std::string& key) {
  return std::stod(settings.at(key));
}

TEST(TradeAxes, NameEveryChoiceThatCostsAccuracy) {
  std::set<std::string> names;
  for (const TradeAxis& axis : trade_axes(scene())) names.insert(axis.name);
  for (const char* name : {"precision", "fused", "fidelity", "step", "spacing", "m", "horizon",
                           "quadrature", "surface", "constants", "micromodulus", "history"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(TradeAxes, VaryWhatTheScriptDoesNotHave) {
  for (const TradeAxis& axis : trade_axes(scene())) {
    EXPECT_FALSE(axis.values.empty()) << axis.name;
    for (const Settings& settings : axis.values) {
      EXPECT_NE(settings, (Settings{{"simulate.precision", "f64"}}));
      EXPECT_NE(settings, (Settings{{"simulate.quadrature", "full"}}));
      EXPECT_NE(settings, (Settings{{"simulate.constants", "paper"}}));
      if (axis.name == "m") {
        EXPECT_NEAR(number(settings, "simulate.horizon"), 4e-3, 1e-9) << "the horizon stays";
      }
      if (axis.name == "spacing") {
        EXPECT_NEAR(number(settings, "simulate.horizon") / number(settings, "simulate.spacing"),
                    4.0, 1e-9)
            << "m stays";
      }
      if (axis.name == "horizon") {
        EXPECT_EQ(number(settings, "simulate.spacing"), 1e-3);
      }
    }
  }
}

TEST(TradeAxes, TakeAwayAStepThatTheScriptGives) {
  SceneNumerics given = scene();
  given.has_step = true;
  for (const TradeAxis& axis : trade_axes(given)) {
    if (axis.name != "step") continue;
    for (const Settings& settings : axis.values) EXPECT_EQ(settings.at("simulate.step"), "default");
  }
  EXPECT_EQ(reference_settings(given, 40.0)[0].at("simulate.step"), "default");
}

TEST(TradeReference, IsFinerInEveryRespectAndAffordable) {
  const Settings finest = reference_settings(scene(), 100.0)[0];
  const double spacing = number(finest, "simulate.spacing");
  EXPECT_DOUBLE_EQ(spacing, 0.5e-3);
  EXPECT_NEAR(number(finest, "simulate.horizon") / spacing, 6.0, 1e-9);
  EXPECT_DOUBLE_EQ(number(finest, "simulate.safety"), 0.45);
  EXPECT_EQ(finest.at("simulate.precision"), "f64");
  EXPECT_EQ(finest.at("simulate.quadrature"), "area");
  const Settings cheap = reference_settings(scene(), 3.0)[0];
  EXPECT_GT(number(cheap, "simulate.spacing"), 0.6e-3);
  EXPECT_LT(number(cheap, "simulate.spacing"), 0.8e-3);
}

TEST(TradeReference, HasSimplerOnesForScenesThatRefuseIt) {
  const std::vector<Settings> all = reference_settings(scene(), 40.0);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_TRUE(all[0].contains("simulate.surface"));
  EXPECT_FALSE(all[1].contains("simulate.surface"));
  EXPECT_FALSE(all[2].contains("simulate.quadrature"));
}

}  // namespace
}  // namespace hackle
