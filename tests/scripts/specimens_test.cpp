// SPDX-License-Identifier: MIT
// The ready specimens against the handbooks that their headers name.
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// Relative errors of what the gauges measure and of K; 0 where the handbook has none.
struct Errors {
  double displacement = 0.0, intensity = 0.0;
};

struct SpecimenCase {
  const char* name;
  const char* dimensions;  // in Lua
  const char* spacing;     // in Lua, of the coarser of two lattices; the horizon is 4 spacings
  Errors corrected;        // on it, with surface = "energy"
  int tips = 1;
  const char* quadrature = "full";
};

Errors errors_of(const SpecimenCase& given, int refinement, const char* surface = "none") {
  Console console(test::quiet());
  console.evaluate(
      fmt::format("measured, K, at = require('specimens.parts').solve(require('specimens.{}'), {}, "
                  "{{ spacing = {}/{}, quadrature = '{}', surface = '{}' }}, {})",
                  given.name, given.dimensions, given.spacing, refinement, given.quadrature,
                  surface, given.tips));
  const auto error = [&](const char* found, const char* expected) {
    const std::string ratio = fmt::format("{1} and {0}/{1} - 1 or 0", found, expected);
    return std::stod(console.evaluate(ratio).at(0));
  };
  return {error("measured", "at.displacement"), error("K", "at.K")};
}

class EverySpecimen : public testing::TestWithParam<SpecimenCase> {};

// The error is of the first order in the horizon: the rim of a plate of bonds is soft for a
// horizon, and a crack is open a part of a horizon beyond its end. So half the horizon halves it,
// and twice the finer value less the coarser one leaves what is of the second order and what the
// handbooks themselves are wrong by: up to 1 % for K and twice that for places on the rim.
TEST_P(EverySpecimen, ConvergesToTheHandbook) {
  const Errors coarse = errors_of(GetParam(), 1), fine = errors_of(GetParam(), 2);
  RecordProperty("displacement",
                 fmt::format("{:+.4f} {:+.4f}", coarse.displacement, fine.displacement));
  RecordProperty("K", fmt::format("{:+.4f} {:+.4f}", coarse.intensity, fine.intensity));
  EXPECT_LT(std::abs(coarse.displacement), 0.19);
  EXPECT_LT(std::abs(fine.displacement), 0.10);
  EXPECT_LT(std::abs(fine.intensity), 0.07);
  EXPECT_NEAR(2.0 * fine.displacement - coarse.displacement, 0.0, 0.03);
  EXPECT_NEAR(2.0 * fine.intensity - coarse.intensity, 0.0, 0.015);
}

// With stiffened surfaces bars are within 0.2 % (dog bone) and beams within 2 % (three-point bend):
// the rest is what a crack is open beyond its end, for which faces are not corrected, a part of a
// horizon that makes it longer, and grows with d(ln K)/da: 2 % of a long cantilever, 4 % where the
// ligament is short. The corner of the panel is softer in the same way, and is compared with finite
// elements.
TEST_P(EverySpecimen, IsNearTheHandbookWithCorrectedSurfaces) {
  const Errors found = errors_of(GetParam(), 1, "energy");
  RecordProperty("corrected", fmt::format("{:+.4f} {:+.4f}", found.displacement, found.intensity));
  EXPECT_NEAR(found.displacement, GetParam().corrected.displacement, 0.005);
  EXPECT_NEAR(found.intensity, GetParam().corrected.intensity, 0.005);
}

INSTANTIATE_TEST_SUITE_P(
    Specimens, EverySpecimen,
    testing::Values(
        SpecimenCase{"compact_tension", "{}", "1*mm", {0.067, 0.027}},
        SpecimenCase{"compact_tension", "{ W = 40*mm, a = 16*mm }", "0.8*mm", {0.074, 0.027}},
        SpecimenCase{"single_edge_bend", "{}", "0.5*mm", {0.042, 0.043}},
        SpecimenCase{"three_point_bend", "{}", "0.2*mm", {0.018}},
        SpecimenCase{"brazilian_disc", "{}", "0.5*mm", {-0.012}, 1, "area"},
        SpecimenCase{"brazilian_disc", "{ a = 8*mm }", "0.5*mm", {0.0, 0.031}, 2, "area"},
        SpecimenCase{"double_cantilever", "{}", "1*mm", {0.043, 0.021}},
        SpecimenCase{"dog_bone", "{}", "0.5*mm", {0.0}},
        SpecimenCase{"l_panel", "{}", "5*mm", {0.037}},
        SpecimenCase{"plate_with_pins", "{}", "1*mm", {0.054, 0.043}, 2}),
    [](const auto& given) { return fmt::format("{}_{}", given.param.name, given.index); });

// Stress and stiffness of a bar do not depend on its size, and K grows with its root.
TEST(Specimens, ScaleWithTheirDimensions) {
  Console console(test::quiet());
  console.evaluate("ct = require 'specimens.compact_tension'");
  console.evaluate(
      "_, small = ct { W = 20*mm, load = 1e3 } _, large = ct { W = 80*mm, load = 4e3 }");
  EXPECT_NEAR(std::stod(console.evaluate("large.K/small.K").at(0)), 2.0, 1e-12);
  EXPECT_NEAR(std::stod(console.evaluate("large.displacement/small.displacement").at(0)), 4.0,
              1e-12);
}

// Pins that move apart break the specimen slowly; the crack runs straight ahead.
TEST(Specimens, BreakWhenTheirPinsMove) {
  Console console(test::quiet());
  console.evaluate(R"(
    p, at = require "specimens.compact_tension" { velocity = 1, material = "pmma" }
    s = simulate(p, { spacing = 1.25*mm })
    s:quasistatic { duration = 3*ms, increments = 6 }
    found = s:cracks { from = { at.tip[1] + 4*mm, 0 }, to = { p.width, p.height } })");
  EXPECT_GT(std::stod(console.evaluate("s.damage.broken_bonds").at(0)), 20);
  EXPECT_GT(std::stod(console.evaluate("found.nodes").at(0)), 4);
  EXPECT_NEAR(std::stod(console.evaluate("(found.top + found.bottom)/2 - p.height/2").at(0)), 0.0,
              1e-3);
}

// The gauges of the cantilever lie in its two pins; the panel has one.
TEST(Specimens, MoveTheirPinsApartAtTheGivenVelocity) {
  Console console(test::quiet());
  console.evaluate(R"(
    function moved(name, spacing)
      p, at = require("specimens." .. name) { velocity = 2, material = "pmma" }
      s = simulate(p, { spacing = spacing })
      s:quasistatic { duration = 5*us, increments = 1 }
      return at.measured(s)
    end)");
  EXPECT_NEAR(std::stod(console.evaluate("moved('double_cantilever', 1*mm)").at(0)), 10e-6, 1e-12);
  console.evaluate("moved('l_panel', 10*mm)");
  EXPECT_NEAR(std::stod(console.evaluate("s:at({470*mm, 270*mm}).uy").at(0)), 10e-6, 1e-12);
}

// 51 rows: the crack runs along one of them.
TEST(Specimens, RefuseToMeasureOneNodeAgainstItself) {
  EXPECT_THAT(test::message_of("local p, at = require 'specimens.compact_tension' {}\n"
                               "at.measured(simulate(p, { spacing = 60*mm/51 }))"),
              HasSubstr("test.lua:2: both gauges lie on one node"));
}

TEST(Specimens, RefuseWhatTheyDoNotKnow) {
  const auto message = [](const std::string& dimensions) {
    return test::message_of("local p = require 'specimens.compact_tension' " + dimensions);
  };
  EXPECT_EQ(message("{}"), "");
  EXPECT_THAT(message("{ w = 1 }"), HasSubstr("unknown dimension 'w'; it takes W, a, load"));
  EXPECT_THAT(message("{ W = -1 }"), HasSubstr("test.lua:1: compact_tension: W is -1"));
  for (const char* bad :
       {"{ W = 0/0 }", "{ W = 1/0 }", "{ W = '1' }", "{ load = 0 }", "{ a = {} }"})
    EXPECT_THAT(message(bad), HasSubstr("it must be a number above 0")) << bad;
  EXPECT_THAT(message("{ a = 49*mm }"), HasSubstr("a/W must lie between"));
  EXPECT_THAT(message("(5)"), HasSubstr("takes a table"));
}

}  // namespace
}  // namespace hackle
