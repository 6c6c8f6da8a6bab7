// SPDX-License-Identifier: MIT
#include "store/inputs.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "store/inputs_reader.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

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

// Every member of a scene has a different value, none of them the default.
Numerics every_choice() {
  Numerics numerics;
  numerics.spacing = 0.51e-3;
  numerics.horizon = 1.77e-3;
  numerics.quadrature = Quadrature::centroid;
  numerics.micromodulus = Micromodulus::conical;
  numerics.constants = Constants::continuum;
  numerics.surface = Surface::volume;
  numerics.breaking = Breaking::next_step;
  numerics.precision = Precision::f32;
  numerics.fused = true;
  numerics.fidelity = 0.31;
  numerics.safety = 0.7;
  numerics.step = 1.23e-8;
  numerics.force_step = true;
  return numerics;
}

Material material_like(double seed) {
  Material material;
  material.name = "glass " + std::to_string(seed);
  material.E = seed * 1e9;
  material.rho = seed * 31.0;
  material.nu = 0.01 * seed;
  material.G0 = seed + 0.5;
  material.alpha = seed * 1e-2;
  material.alphaT = seed * 1e-7;
  material.fringe = seed * 1e3;
  material.s0 = seed * 1e-4;
  material.c = seed * 1e20;
  return material;
}

Bitmap some_bitmap() {
  return {{0.011, 0.012}, {0.014, 0.013}, 4, 3, {0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1, 0}};
}

Loads every_load() {
  Loads loads;
  const Amplitude table({{0.0, 0.25}, {1e-6, 1.0}, {1e-6, 0.5}});
  loads.tractions = {{Edge::left, {1e6, 2e6}, 1.1e-3, table}, {Edge::bottom, {-3e6, 4e6}, 0.0, {}}};
  loads.pressures = {{"bore", 5e6, ramp(2e-6)}, {"slit", -6e6, {}}};
  loads.body_forces = {{Ellipse{{0.01, 0.02}, {3e-3, 4e-3}, 0.5}, {7.0, 8.0}, step_at(3e-6)},
                       {std::nullopt, {9.0, -9.5}, {}}};
  loads.supports = {{rectangle({0.0, 0.001}, {0.002, 0.003}),
                     Support::Kind::velocity,
                     {0.1, 0.2},
                     true,
                     false,
                     pulse(1e-6, 2e-6)},
                    {std::nullopt, Support::Kind::displacement, {1e-6, 2e-6}, false, true, {}}};
  loads.thermal_loads = {{Capsule{{{0.01, 0.011}, {0.012, 0.013}}, 1e-3}, 40.0, table},
                         {some_bitmap(), -50.0, {}}};
  loads.impactors = {{{0.02, 0.06}, 2e-3, {3.0, -80.0}, 0.7, 0.2, 0.6}};
  loads.foundations = {{rectangle({0.01, 0.02}, {0.03, 0.04}), 3e13, Foundation::Along::y},
                       {std::nullopt, 4e12, Foundation::Along::both}};
  loads.absorbers = {{Absorber::Where::top}, {Absorber::Where::all}};
  loads.rollers = {{{0.02, 0.06}, 2e-3, Guide::velocity, {0.1, -0.2}, table, 0.3},
                   {{0.03, -0.01}, 3e-3, Guide::displacement, {0.0, 0.0}, {}, 0.0}};
  loads.platens = {{{0.02, 0.06}, {0.04, 0.07}, Guide::displacement, {0.1, -0.2}, table, 0.4},
                   {{0.02, -0.02}, {0.04, -0.01}, Guide::force, {0.1, 0.2}, {}, 0.5, 7.0}};
  loads.damping = 1234.5;
  loads.stiffness_damping = 6.7e-9;
  return loads;
}

Plate every_member() {
  Plate plate;
  plate.width = 0.071;
  plate.height = 0.053;
  plate.material = material_like(61.0);
  plate.plane = Plane::strain;
  plate.cutouts = {{Ellipse{{0.03, 0.031}, {2e-3, 3e-3}, 0.3}, "bore"},
                   {some_bitmap(), "slit", Bridging::keep}};
  plate.outlines = {{{Ring{{0.03, 0.02}, 0.05, 0.002}, some_bitmap()}, "rim"},
                    {{Ellipse{{0.03, 0.03}, {0.08, 0.07}, 0.2}}, ""}};
  plate.inclusions = {{Polygon{{{0.04, 0.01}, {0.05, 0.011}, {0.045, 0.02}}}, material_like(7.0)}};
  plate.cracks = {{{{0.0, 0.02}, {0.01, 0.021}, {0.012, 0.023}}, Born::absent},
                  {{{0.06, 0.04}, {0.07, 0.041}}, Born::broken, CrackEnds::cut}};
  plate.no_fail = {rectangle({0.0, 0.0}, {0.001, 0.053}),
                   Capsule{{{0.05, 0.05}, {0.06, 0.052}}, 1.5e-3}};
  plate.initial_conditions = {{Ellipse{{0.01, 0.01}, {1e-3, 1e-3}, 0.0}, {1e-6, 2e-6}, {3.0, 4.0}},
                              {std::nullopt, {5e-6, 6e-6}, {7.0, 8.0}}};
  plate.scatter = Scatter{Scatter::Kind::normal, 0.11, 1.3e-3, 99};
  plate.contact = Contact{40.0, 0.8, 0.3, 0.5};
  plate.loads = every_load();
  return plate;
}

// tests/console/language/noun_options_test.cpp sees to it that same() compares every member.
TEST(Inputs, KeepEveryMemberOfAPlateAndItsLoads) {
  const Plate wanted = every_member();
  const Plate found = read_inputs(inputs_of(wanted, every_choice())).plate;
  EXPECT_TRUE(same(found, wanted));
  EXPECT_EQ(inputs_of(found, every_choice()), inputs_of(wanted, every_choice()));
}

TEST(Inputs, KeepEveryChoiceOfTheNumerics) {
  EXPECT_TRUE(
      same(read_inputs(inputs_of(every_member(), every_choice())).numerics, every_choice()));
  const Numerics plain = test::numerics();
  EXPECT_TRUE(same(read_inputs(inputs_of(every_member(), plain)).numerics, plain));
}

TEST(Inputs, KeepTheStepThatWasTaken) {
  const Simulation simulation(test::bare_plate(20, 10), test::numerics());
  EXPECT_EQ(read_inputs(inputs_of(simulation)).numerics.step, simulation.dt());
}

TEST(Inputs, OfAPlateWithoutAnythingAreEmpty) {
  const Plate found = read_inputs(inputs_of(test::bare_plate(20, 10), test::numerics())).plate;
  EXPECT_FALSE(found.scatter || found.contact);
  EXPECT_EQ(describe(found), describe(test::bare_plate(20, 10)));
}

TEST(Inputs, MarkFunctionsWhichCannotBeRead) {
  Plate plate = test::bare_plate(20, 10);
  Traction load{Edge::top, VectorField([](const Vec2& at) { return at; }), 0.0,
                Amplitude([](double t) { return t; }, "a function of time")};
  plate.loads.tractions.push_back(load);
  const std::string text = inputs_of(plate, test::numerics());
  EXPECT_THAT(text, HasSubstr("\"function\": \"a function of time\""));
  const Traction found = read_inputs(text).plate.loads.tractions.at(0);
  EXPECT_EQ(found.amplitude.describe(), "a function of time");
  EXPECT_THROW(found.amplitude.at(0.0), Error);
  EXPECT_FALSE(found.stress.is_constant());
  EXPECT_THROW(found.stress.at({0.0, 0.0}), Error);
}

TEST(Inputs, OfAnotherFormAreRefusedWithoutBeingQuoted) {
  const std::string good = inputs_of(every_member(), every_choice());
  for (const auto& [from, to] : {std::pair{"\"plane\": \"strain\"", "\"plane\": \"SECRET\""},
                                 {"\"kind\": \"ellipse\"", "\"kind\": \"SECRET\""},
                                 {"\"edge\": \"left\"", "\"edge\": \"SECRET\""},
                                 {"\"width_m\": ", "\"width_m\": SECRET"},
                                 {"\"width_m\": ", "\"width_m\": \"SECRET\", \"x\": "},
                                 {"\"run_lengths\": \"", "\"run_lengths\": \"SECRET"},
                                 {"\"contact\": {", "\"contact\": [\"SECRET\"], \"x\": {"}}) {
    std::string text = good;
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, std::string(from).size(), to);
    try {
      read_inputs(text);
      FAIL() << to;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::files);
      EXPECT_THAT(error.what(), testing::Not(HasSubstr("SECRET"))) << to;
    }
  }
}

TEST(Inputs, AreReadUntilSomebodyInterrupts) {
  const std::string text = inputs_of(every_member(), every_choice());
  request_interrupt();
  EXPECT_THROW(read_inputs(text), Error);
  clear_interrupt();
}

}  // namespace
}  // namespace hackle
