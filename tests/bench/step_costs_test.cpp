// SPDX-License-Identifier: MIT
// The cost of a step in instructions, which no other process disturbs: unused options cost nothing,
// and used ones cost what they must. Counted by valgrind; skipped without it.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "base/text.hpp"
#include "support/skipping.hpp"

namespace hackle {
namespace {

bool valgrind_is_installed() {
  return std::system("command -v valgrind > /dev/null 2>&1") == 0;
}

// Returns the instructions of the whole program.
double count(int steps, int nodes, const std::string& words) {
  const std::string command = "valgrind --tool=callgrind --callgrind-out-file=/dev/null " +
                              shell_word(HACKLE_COUNT_STEPS) + " " + std::to_string(steps) + " " +
                              std::to_string(nodes) + " " + words + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  std::string said;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) said += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0) << said;
  std::smatch match;
  if (!std::regex_search(said, match, std::regex("Collected : (\\d+)"))) {
    ADD_FAILURE() << said;
    return 0.0;
  }
  return std::stod(match[1]);
}

// Returns the instructions per step and node of the plate.
double per_node_step(const std::string& words, int nodes = 16000) {
  constexpr int few = 2, many = 6;
  return (count(many, nodes, words) - count(few, nodes, words)) / (nodes * double{many - few});
}

class StepCosts : public testing::Test {
 protected:
  void SetUp() override {
    HACKLE_NEEDS(valgrind_is_installed(), "valgrind counts, and it is not on the PATH");
  }
};

TEST_F(StepCosts, NoFailZonesCostNothingWhereNoBondCanBreak) {
  EXPECT_NEAR(per_node_step("f64 zones") / per_node_step("f64"), 1.0, 0.01);
}

// The history adds about two multiplications and minima per bond and a root per node: a scene
// without history must do without all of them.
TEST_F(StepCosts, AHistoryOfStretchIsPaidForByTheScenesThatHaveOne) {
  for (const std::string precision : {"f32", "f64"}) {
    const double plain = per_node_step(precision), history = per_node_step(precision + " alpha");
    EXPECT_GT(history, 1.15 * plain) << precision;
    EXPECT_LT(history, 1.8 * plain) << precision;
  }
}

// Per bond: two loads, of which one is shared, an addition and a multiplication. A scene of one
// cold material must do without, and neither feature must pay for the other.
TEST_F(StepCosts, MaterialsAndTemperatureArePaidForByTheScenesThatHaveThem) {
  for (const std::string precision : {"f32", "f64"}) {
    const double plain = per_node_step(precision), mixed = per_node_step(precision + " mixed"),
                 heated = per_node_step(precision + " heated"),
                 both = per_node_step(precision + " mixed heated");
    EXPECT_GT(mixed, 1.02 * plain) << precision;
    EXPECT_LT(mixed, 1.35 * plain) << precision;
    EXPECT_GT(heated, 1.02 * plain) << precision;
    EXPECT_LT(heated, 1.35 * plain) << precision;
    EXPECT_GT(both, std::max(mixed, heated)) << precision;
    EXPECT_LT(both, 1.6 * plain) << precision;
  }
}

TEST_F(StepCosts, LinearisedForcesSaveWork) {
  constexpr int nodes = 400000;  // tiles at edges and cracks are exact for ever: here they are few
  EXPECT_LT(per_node_step("f32 fidelity", nodes), 0.85 * per_node_step("f32", nodes));
}

TEST_F(StepCosts, SinglePrecisionHalvesTheWork) {
  const double ratio = per_node_step("f32") / per_node_step("f64");
  EXPECT_LT(ratio, 0.55);
  EXPECT_GT(ratio, 0.3);
}

}  // namespace
}  // namespace hackle
