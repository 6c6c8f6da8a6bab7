// SPDX-License-Identifier: MIT
#include "output/report.hpp"

#include <gmock/gmock.h>

#include "output/features.hpp"
#include "output/run.hpp"
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
                     HasSubstr("steps of 209 ns (limit 232.4 ns)"), HasSubstr("J/m put in")));
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
  plate.loads.tractions.front().course = ramp(1e-6);
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
              testing::ElementsAre(HasSubstr("the lattice is 10 mm x 5 mm")));
}

TEST(Remarks, TellWhatThePapersConstantsAmountTo) {
  Numerics numerics = test::numerics();
  numerics.constants = Constants::paper;
  EXPECT_THAT(remarks(Simulation(test::bare_plate(20, 10), numerics)),
              testing::ElementsAre(HasSubstr("paper constants give 0.822 of the material's E and "
                                             "0.774 of its G0")));
}

}  // namespace
}  // namespace hackle
