// SPDX-License-Identifier: MIT
#include "scene/loads.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Loads, AreCountedByKind) {
  Loads loads;
  loads.tractions.resize(2);
  EXPECT_EQ(describe(loads), ", 2 tractions");
  loads.pressures.resize(1);
  loads.body_forces.resize(3);
  loads.supports.resize(4);
  loads.thermal_loads.resize(5);
  loads.impactors.resize(6);
  loads.damping = 1.0;
  EXPECT_EQ(describe(loads),
            ", 2 tractions, 1 pressure, 3 body forces, 4 supports, 5 temperature changes, 6 "
            "impactors, damping");
}

// Everything that can be wrong on a plate, one at a time: the message must name it.
struct Wrong {
  const char* part;  // of the message
  void (*spoil)(Plate&);
};

class Wrongs : public testing::TestWithParam<Wrong> {};

TEST_P(Wrongs, AreFoundByThemselves) {
  Plate plate = test::edge_crack(12e6);
  GetParam().spoil(plate);
  Problems problems;
  check(plate, problems);
  ASSERT_EQ(problems.list().size(), 1U);
  EXPECT_THAT(problems.list().front().what, testing::HasSubstr(GetParam().part));
}

Impactor disc() {
  return {{0.05, 0.1}, 1e-3, {0.0, -10.0}, 1.0};
}

Amplitude backwards() {
  return Amplitude({{1.0, 0.0}, {0.0, 1.0}});
}

INSTANTIATE_TEST_SUITE_P(
    Parts, Wrongs,
    testing::Values(
        Wrong{"E is -1", [](Plate& p) { p.material.E = -1.0; }},
        Wrong{"cut-out",
              [](Plate& p) {
                p.cutouts.push_back({Ellipse{{1, 1}, {0.1, 0.1}, 0}, ""});
              }},
        Wrong{"inclusion",
              [](Plate& p) {
                p.inclusions.push_back({Ellipse{{0.01, 0.01}, {0, 0.1}, 0}, p.material});
              }},
        Wrong{"rho is -2",
              [](Plate& p) {
                p.inclusions.push_back({rectangle({0, 0}, {0.01, 0.01}), p.material});
                p.inclusions.back().material.rho = -2.0;
              }},
        Wrong{"crack",
              [](Plate& p) {
                p.cracks.push_back({{0.0, 0.0}, {0.0, 0.0}});
              }},
        Wrong{"nofail",
              [](Plate& p) {
                p.no_fail.push_back(rectangle({1, 1}, {2, 2}));
              }},
        Wrong{"modulus is 0.5", [](Plate& p) { p.scatter = Scatter{.spread = 0.5}; }},
        Wrong{"deviation is 0.4",
              [](Plate& p) {
                p.scatter = Scatter{Scatter::Kind::normal, 0.4, 0.0, 1};
              }},
        Wrong{"correlation is -1",
              [](Plate& p) {
                p.scatter = Scatter{Scatter::Kind::normal, 0.1, -1.0, 1};
              }},
        Wrong{"stiffness is 0",
              [](Plate& p) {
                p.contact = Contact{0.0, 0.9};
              }},
        Wrong{"stiffness is 101",
              [](Plate& p) {
                p.contact = Contact{101.0, 0.9};
              }},
        Wrong{"reach is 0",
              [](Plate& p) {
                p.contact = Contact{15.0, 0.0};
              }},
        Wrong{"reach is 1.5",
              [](Plate& p) {
                p.contact = Contact{15.0, 1.5};
              }},
        Wrong{"traction", [](Plate& p) { p.loads.tractions[1].stress = Vec2(0.0, nan); }},
        Wrong{"traction", [](Plate& p) { p.loads.tractions[1].depth = -1.0; }},
        Wrong{"traction", [](Plate& p) { p.loads.tractions[1].amplitude = backwards(); }},
        Wrong{"body_force",
              [](Plate& p) {
                p.loads.body_forces.push_back({{}, {nan, 0}, {}});
              }},
        Wrong{"body_force",
              [](Plate& p) {
                p.loads.body_forces.push_back({{}, {1, 0}, backwards()});
              }},
        Wrong{"body_force",
              [](Plate& p) {
                p.loads.body_forces.push_back({rectangle({0, 0}, {0, 1}), {1, 0}, {}});
              }},
        Wrong{"support", [](Plate& p) { p.loads.supports.push_back({.value = Vec2(nan, 0.0)}); }},
        Wrong{"support", [](Plate& p) { p.loads.supports.push_back({.amplitude = backwards()}); }},
        Wrong{"support",
              [](Plate& p) {
                p.loads.supports.push_back({.region = rectangle({0, 0}, {0, 1})});
              }},
        Wrong{"temperature",
              [](Plate& p) {
                p.material.alphaT = 1e-6;
                p.loads.thermal_loads.push_back({{}, nan, {}});
              }},
        Wrong{"temperature",
              [](Plate& p) {
                p.material.alphaT = 1e-6;
                p.loads.thermal_loads.push_back({{}, 1.0, backwards()});
              }},
        Wrong{"temperature",
              [](Plate& p) {
                p.material.alphaT = 1e-6;
                p.loads.thermal_loads.push_back({rectangle({0, 0}, {0, 1}), 1.0, {}});
              }},
        Wrong{"impactor: radius",
              [](Plate& p) {
                p.loads.impactors = {disc(), disc()};
                p.loads.impactors[1].radius = 0.0;
              }},
        Wrong{"impactor: mass",
              [](Plate& p) {
                p.loads.impactors = {disc(), disc()};
                p.loads.impactors[1].mass = -1.0;
              }},
        Wrong{"impactor: centre",
              [](Plate& p) {
                p.loads.impactors = {disc()};
                p.loads.impactors[0].centre.y() = nan;
              }},
        Wrong{"impactor: velocity",
              [](Plate& p) {
                p.loads.impactors = {disc()};
                p.loads.impactors[0].velocity.y() = nan;
              }},
        Wrong{"damping", [](Plate& p) { p.loads.damping = -1.0; }},
        Wrong{"damping", [](Plate& p) { p.loads.damping = nan; }},
        Wrong{"no hole, notch, outline or crack named 'b'",
              [](Plate& p) {
                p.cutouts.push_back({Ellipse{{0.01, 0.01}, {1e-3, 1e-3}, 0}, "a"});
                p.loads.pressures = {{"a", 1e6, {}}, {"b", 1e6, {}}};
              }},
        Wrong{"pressure",
              [](Plate& p) {
                p.cutouts.push_back({Ellipse{{0.01, 0.01}, {1e-3, 1e-3}, 0}, "a"});
                p.loads.pressures = {{"a", nan, {}}};
              }},
        Wrong{"pressure", [](Plate& p) {
                p.cutouts.push_back({Ellipse{{0.01, 0.01}, {1e-3, 1e-3}, 0}, "a"});
                p.loads.pressures = {{"a", 1e6, backwards()}};
              }}));

}  // namespace
}  // namespace hackle
