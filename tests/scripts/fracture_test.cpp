// SPDX-License-Identifier: MIT
// J and K of handbook bodies with 20 nodes in the ligament, with surface = "energy" and m = 3.
// Measured errors at two spacings: tests/README.md, "Fracture mechanics".
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

// Solves the body of plate p and table `at` and expects its K within 3 % and its spread below 0.2
// %.
void expect_handbook(const std::string& body, const char* spacing, const char* tip) {
  Console console(test::quiet());
  console.evaluate(body);
  console.evaluate(fmt::format(
      "s = simulate(p, {{ spacing = {0}, horizon = 3*{0}, surface = 'energy' }}) s:relax()\n"
      "f = s:fracture {1}",
      spacing, tip));
  const auto number = [&](const char* what) { return std::stod(console.evaluate(what).at(0)); };
  EXPECT_NEAR(number("f.K_J/K"), 1.0, 0.03);
  EXPECT_NEAR(number("f.K_I/K"), 1.0, 0.03);
  EXPECT_NEAR(number("f.williams_K_I/K"), 1.0, 0.03);
  EXPECT_NEAR(number("f.K_II/K"), 0.0, 1e-3);
  EXPECT_LT(number("f.spread"), 2e-3);
}

// Tada, Paris and Irwin: sec(pi a/W)^(1/2) (1 - 0.025 x^2 + 0.06 x^4) with x = 2a/W = 1/2.
TEST(FractureOfBodies, OfACentreCrackIsThatOfTheHandbook) {
  expect_handbook(R"(
    p = plate { width = 40*mm, height = 60*mm, material = "duran50" }
    p:crack { from = {10*mm, 30*mm}, to = {30*mm, 30*mm} }
    for edge, sign in pairs { top = 1, bottom = -1 } do p:traction { edge = edge, stress = {0, sign*MPa} } end
    K = 1*MPa*math.sqrt(math.pi*10*mm/math.cos(math.pi/4))*(1 - 0.025/4 + 0.06/16))",
                  "0.5*mm", "{}");
}

TEST(FractureOfBodies, OfACompactTensionSpecimenIsThatOfE399) {
  expect_handbook("p, at = require 'specimens.compact_tension' { W = 40*mm } K = at.K", "1*mm",
                  "{ tip = at.tip, direction = {1, 0} }");
}

}  // namespace
}  // namespace hackle
