// SPDX-License-Identifier: MIT
#include "output/report/report.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/units.hpp"
#include "output/files/movie_options.hpp"
#include "output/files/record_options.hpp"
#include "output/report/features.hpp"
#include "output/report/summary.hpp"
#include "output/run/run.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

TEST(Report, SaysWhatWasSolvedAndHow) {
  hackle::Run run(test::edge_crack(12e6), test::numerics(), {1}, Talk::quiet, {"x.lua", ""});
  run.run(1e-6);
  EXPECT_THAT(
      run.report(),
      testing::AllOf(HasSubstr("plate 100 x 40 mm, Duran 50 glass"),
                     HasSubstr("16 000 nodes, 372 854 bonds; spacing 0.5 mm, horizon 2 mm "
                               "(m = 4); full quadrature"),
                     HasSubstr("plane stress, lattice constants, constant micromodulus: E 65 GPa "
                               "(material 65 GPa), nu 0.317 (material 0.2), G0 204 J/m2"),
                     HasSubstr("steps of 200 ns (limit 232.4 ns)"), HasSubstr("J/m put in")));
}

// A platen that does not touch the plate bears nothing.
TEST(Report, SaysWhatBodiesBear) {
  Plate plate = test::bare_plate(20, 10);
  plate.loads.platens.push_back({{0.0, 8e-3}, {10e-3, 10e-3}, {}});
  const hackle::Run run(plate, test::numerics(), {1}, Talk::quiet, {"x.lua", ""});
  EXPECT_THAT(run.report(), HasSubstr("\n  forces   platen 1 at (5 mm, 9 mm) bears (0, 0) N/m, "
                                      "moment 0 N\n"));
  const hackle::Run bare(test::bare_plate(20, 10), test::numerics(), {1}, Talk::quiet,
                         {"x.lua", ""});
  EXPECT_THAT(bare.report(), testing::Not(HasSubstr("forces")));
}

// A material whose critical stretch is given has no fracture energy to compare with.
TEST(Report, ComparesNoFractureEnergyWhereTheStretchIsGiven) {
  Plate plate = test::bare_plate(20, 10);
  plate.material.G0 = 0.0;
  plate.material.s0 = 1e-3;
  EXPECT_THAT(remarks(Simulation(plate, test::numerics(), {1})),
              testing::Not(testing::Contains(HasSubstr("of its G0"))));
  Numerics numerics = test::numerics();
  numerics.constants = Constants::continuum;
  EXPECT_THAT(remarks(Simulation(plate, numerics, {1})),
              testing::Contains(testing::AllOf(HasSubstr("of the material's E on this lattice"),
                                               testing::Not(HasSubstr("G0")))));
}

TEST(Report, SaysPlaneQuadratureAndMicromodulus) {
  Plate plate = test::edge_crack(12e6);
  plate.plane = Plane::strain;
  Numerics numerics = test::numerics();
  numerics.quadrature = Quadrature::area;
  numerics.micromodulus = Micromodulus::conical;
  numerics.constants = Constants::continuum;
  const hackle::Run run(plate, numerics, {1}, Talk::quiet, {"x.lua", ""});
  EXPECT_THAT(run.report(),
              testing::AllOf(HasSubstr("plate 100 x 40 mm, plane strain, Duran 50 glass"),
                             HasSubstr("area quadrature"),
                             HasSubstr("plane strain, continuum constants, conical micromodulus: "),
                             HasSubstr("nu 0.246 (material 0.2)")));
}

TEST(Report, SaysWhatIsSwitchedOn) {
  Plate plate = test::edge_crack(12e6);
  plate.contact = Contact{};
  plate.scatter = Scatter{Scatter::Kind::weibull, 20.0, 0.0, 1};
  plate.loads.damping = 1e3;
  plate.loads.tractions.front().amplitude = ramp(1e-6);
  hackle::Run run(plate, test::numerics(), {1}, Talk::quiet, {"x.lua", ""});
  run.run(2e-6);
  EXPECT_THAT(run.report(),
              testing::ContainsRegex("steps    kernel [0-9.]+ % \\(no-fail zones, scatter of "
                                     "strength\\), damping [0-9.]+ %, varying loads [0-9.]+ %, "
                                     "contact [0-9.]+ %\n"));
  double sum = 0.0;
  for (const Stage& stage : stages(run.simulation())) {
    EXPECT_GT(stage.share, 0.0) << stage.name;
    sum += stage.share;
  }
  EXPECT_NEAR(sum, 1.0, 1e-9);
}

TEST(Report, HasTheKernelAloneForAPlainScene) {
  hackle::Run run(test::bare_plate(20, 10), test::numerics(), {1}, Talk::quiet, {"x.lua", ""});
  EXPECT_THAT(run.report(), HasSubstr("steps    kernel 0.0 %\n"));
}

TEST(Remarks, AreSilentForAnOrdinaryScene) {
  EXPECT_THAT(remarks(Simulation(test::edge_crack(12e6), test::numerics())), testing::IsEmpty());
}

TEST(Remarks, TellOfAPlateThatIsNoWholeNumberOfSpacings) {
  Plate plate = test::bare_plate(20, 10);
  plate.width += 0.1e-3;
  EXPECT_THAT(remarks(Simulation(plate, test::numerics())),
              testing::Contains(HasSubstr("the lattice is 10 mm x 5 mm")));
}

TEST(Remarks, QuestionAPlateOfAHundredMetres) {
  Plate plate = test::bare_plate(20, 10);
  plate.width = 100.0;
  plate.height = 50.0;
  EXPECT_THAT(
      remarks(Simulation(plate, test::numerics(5.0, 15.0))),
      testing::Contains(HasSubstr("the plate is 100 m long: lengths are in metres, as in 100*mm")));
}

TEST(Remarks, TellWhatThePapersConstantsAmountTo) {
  Numerics numerics = test::numerics();
  numerics.constants = Constants::paper;
  EXPECT_THAT(remarks(Simulation(test::bare_plate(20, 10), numerics)),
              testing::Contains(HasSubstr("paper constants give 0.822 of the material's E and "
                                          "0.774 of its G0")));
}

// Checks each line with values that all differ.
TEST(Report, HasEveryNumberInItsPlace) {
  Plate plate = test::bare_plate(40, 20);
  plate.material.nu = 0.17;
  plate.cutouts.push_back({rectangle({5e-3, 2.5e-3}, {7.5e-3, 5e-3}), ""});  // 5 x 5 nodes
  Numerics numerics = test::numerics();
  numerics.constants = Constants::continuum;
  const Simulation simulation(plate, numerics, {1});
  Summary summary;
  summary.nodes = 1001;
  summary.bonds = 1002;
  summary.steps = 1003;
  summary.time = 1.5e-6;
  summary.dt = 2.5e-9;
  summary.dt_limit = 3.5e-9;
  summary.precision = "f32";
  summary.threads = 4;
  summary.wall = {0.0, 1.25, 2.25, 3.25, 4.25, 9.0};
  summary.energy.external = 100.0;
  summary.energy.kinetic = 11.0;
  summary.energy.strain = 12.0;
  summary.energy.broken = 13.0;
  summary.energy.damped = 14.0;
  summary.energy.released = 16.0;
  summary.energy.contact = 15.0;
  summary.damage = {1004, 0.625};
  summary.paths[static_cast<std::size_t>(Path::still)] = 1;
  summary.paths[static_cast<std::size_t>(Path::damaged)] = 3;
  summary.hash = "f00d";
  const Calibration& calibration = simulation.lattice().calibration;
  const std::string model = fmt::format(
      "plane stress, continuum constants, constant micromodulus: E {} (material 65 GPa), nu {:.3f} "
      "(material 0.17), G0 {} (material 204 J/m2), s0 {:.4g}",
      quantity(calibration.moduli.E, "Pa"), calibration.moduli.nu, quantity(calibration.G0, "J/m2"),
      calibration.s0);
  const std::string text = report(simulation, summary);
  for (const std::string& part :
       {std::string("1 001 nodes (775 of material), 1 002 bonds; spacing 0.5 mm, horizon 2 mm"),
        model, std::string("1.5 us in 1 003 steps of 2.5 ns (limit 3.5 ns)"),
        std::string("1 004 bonds broken since the start, largest damage of a node 0.62"),
        std::string("100 J/m put in = 11 kinetic + 12 strain + 13 broken + 14 damped + 16 released "
                    "+ 15 in contacts; residual 19 %"),
        std::string("still 25.0 %, damaged 75.0 %"), std::string("solve 1.25 s on 4 threads"),
        std::string("M node-steps/s (f32 "),
        std::string("; render 2.25 s; encode 3.25 s; store 4.25 s"), std::string("f00d")})
    EXPECT_THAT(text, HasSubstr(part));
}

// Checks every feature of a kernel or a step separately.
TEST(Report, NamesEachFeatureByItself) {
  struct Case {
    const char* text;
    void (*add)(Plate&, Numerics&);
  };
  const Case cases[] = {
      {"no-fail zones",
       [](Plate& p, Numerics&) {
         p.no_fail.push_back(rectangle({0, 0}, {1e-3, 1e-3}));
       }},
      {"2 materials",
       [](Plate& p, Numerics&) {
         Material other = p.material;
         other.E *= 2.0;
         p.inclusions.push_back({rectangle({0, 0}, {2e-3, 2e-3}), other});
       }},
      {"surface energy", [](Plate&, Numerics& n) { n.surface = Surface::energy; }},
      {"scatter of strength",
       [](Plate& p, Numerics&) {
         p.scatter = Scatter{Scatter::Kind::normal, 0.1, 0.0, 1};
       }},
      {"alpha", [](Plate& p, Numerics&) { p.material.alpha = 0.1; }},
      {"thermal strain",
       [](Plate& p, Numerics&) {
         p.material.alphaT = 1e-6;
         p.loads.thermal_loads.push_back({{}, 10.0, {}});
       }},
      {"fidelity 0.25", [](Plate&, Numerics& n) { n.fidelity = 0.25; }}};
  for (const Case& one : cases) {
    Plate plate = test::bare_plate(40, 20);
    Numerics numerics = test::numerics();
    one.add(plate, numerics);
    const Simulation simulation(plate, numerics, {1});
    EXPECT_THAT(kernel_features(simulation), testing::ElementsAre(one.text));
  }
}

TEST(Report, NamesEachStageByItself) {
  struct Case {
    const char* name;
    void (*add)(Plate&);
  };
  const Case cases[] = {{"damping", [](Plate& p) { p.loads.damping = 1.0; }},
                        {"heat",
                         [](Plate& p) {
                           p.material.alphaT = 1e-6;
                           p.loads.thermal_loads.push_back({{}, 10.0, {}});
                         }},
                        {"varying loads",
                         [](Plate& p) {
                           p.loads.tractions.push_back({Edge::top, {0, 1}, 0.0, ramp(1e-6)});
                         }},
                        {"varying loads",
                         [](Plate& p) {
                           p.cutouts.push_back({rectangle({5e-3, 2.5e-3}, {7.5e-3, 5e-3}), "h"});
                           p.loads.pressures.push_back({"h", 1.0, ramp(1e-6)});
                         }},
                        {"varying loads",
                         [](Plate& p) {
                           p.loads.body_forces.push_back({{}, {0, 1}, ramp(1e-6)});
                         }},
                        {"varying loads", [](Plate& p) { p.loads.supports.push_back({}); }},
                        {"contact", [](Plate& p) { p.contact = Contact{}; }},
                        {"impactors", [](Plate& p) {
                           p.loads.impactors.push_back({{-5e-3, 5e-3}, 2e-3, {1.0, 0.0}, 10.0});
                         }}};
  for (const Case& one : cases) {
    Plate plate = test::bare_plate(40, 20);
    one.add(plate);
    const std::vector<Stage> found = stages(Simulation(plate, test::numerics(), {1}));
    ASSERT_EQ(found.size(), 2U) << one.name;
    EXPECT_EQ(found[0].name, "kernel");
    EXPECT_EQ(found[1].name, one.name);
  }
  Plate constant = test::bare_plate(40, 20);
  constant.loads.tractions.push_back({Edge::top, {0, 1}, 0.0, {}});
  EXPECT_EQ(stages(Simulation(constant, test::numerics(), {1})).size(), 1U);
}

}  // namespace
}  // namespace hackle
