// SPDX-License-Identifier: MIT
#include "lattice/check_numerics.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "lattice/lattice.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t plenty = std::uint64_t{1} << 40;

std::string problems_of(const Plate& plate, const Numerics& numerics,
                        std::uint64_t memory = plenty) {
  Problems problems;
  check(plate, numerics, memory, problems);
  try {
    problems.throw_if_any();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
  return "";
}

std::string problems_of(const Numerics& numerics, std::uint64_t memory = plenty) {
  return problems_of(test::edge_crack(12e6), numerics, memory);
}

TEST(Numerics, TheUsualChoicesAreAccepted) {
  EXPECT_EQ(problems_of(test::numerics()), "");
  EXPECT_EQ(problems_of(test::numerics(0.5e-3, 1e-3)), "");  // exactly two spacings
}

TEST(Numerics, SpacingMustBePositiveAndFit) {
  for (const double bad : {0.0, -1e-3, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THAT(problems_of(test::numerics(bad)),
                HasSubstr(bad == bad ? "it must be above 0 m" : "spacing is nan"));
  EXPECT_THAT(problems_of(test::numerics(0.05, 0.2)), HasSubstr("larger than the plate"));
}

TEST(Numerics, TheHorizonMustSpanTwoToSixteenSpacings) {
  EXPECT_THAT(problems_of(test::numerics(0.5e-3, 0.9e-3)), HasSubstr("under 2 spacings"));
  EXPECT_THAT(problems_of(test::numerics(0.5e-3, 9e-3)), HasSubstr("over 16 spacings"));
}

TEST(Numerics, TooManyNodesSayHowMuchIsNeededAndHowMuchThereIs) {
  const std::string text = problems_of(test::numerics(1e-6, 4e-6), std::uint64_t{8} << 30);
  EXPECT_THAT(text, HasSubstr("4e+09 nodes need"));
  EXPECT_THAT(text, HasSubstr("8.59 GB are free"));
  EXPECT_THAT(text, HasSubstr("a spacing of"));
}

TEST(Numerics, EvenAnAbsurdSpacingIsRefusedForItsMemory) {
  EXPECT_THAT(problems_of(test::numerics(1e-300, 4e-300)), HasSubstr("memory"));
}

TEST(Numerics, AStepAboveTheLimitIsRefusedUnlessForced) {
  Numerics numerics = test::numerics();
  numerics.step = 240e-9;
  EXPECT_THAT(problems_of(numerics), HasSubstr("step is 240 ns, above the stability limit of 232"));
  numerics.force_step = true;
  EXPECT_EQ(problems_of(numerics), "");
}

TEST(Numerics, TheStepLimitIsThatOfThePlaneTheQuadratureAndTheMicromodulus) {
  Plate plate = test::edge_crack(12e6);
  Numerics numerics = test::numerics();
  for (const auto plane : {Plane::stress, Plane::strain})
    for (const auto quadrature : {Quadrature::full, Quadrature::area, Quadrature::centroid})
      for (const auto micromodulus : {Micromodulus::constant, Micromodulus::conical}) {
        plate.plane = plane;
        numerics.quadrature = quadrature;
        numerics.micromodulus = micromodulus;
        const double limit = Lattice(plate, numerics).step_limit;
        numerics.step = 0.999 * limit;
        EXPECT_EQ(problems_of(plate, numerics), "");
        numerics.step = 1.001 * limit;
        EXPECT_THAT(problems_of(plate, numerics), HasSubstr("above the stability limit"));
      }
}

TEST(Numerics, FidelityIsAShareAndNotForMaterialsWithAHistory) {
  Numerics numerics = test::numerics();
  for (const double bad : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    numerics.fidelity = bad;
    EXPECT_THAT(problems_of(numerics),
                HasSubstr(bad == bad ? "it must be between 0 and 1" : "fidelity is nan"));
  }
  numerics.fidelity = 0.3;
  EXPECT_EQ(problems_of(numerics), "");
  Plate plate = test::edge_crack(12e6);
  plate.material.alpha = 0.25;
  EXPECT_THAT(problems_of(plate, numerics),
              HasSubstr("fidelity is 0.3 and the material's alpha 0.25"));
  Plate filled = test::edge_crack(12e6);  // the history of an inclusion counts, too
  filled.inclusions.push_back({Ellipse{{0.07, 0.02}, {2e-3, 2e-3}, 0.0}, filled.material});
  filled.inclusions.back().material.alpha = 0.1;
  EXPECT_THAT(problems_of(filled, numerics),
              HasSubstr("fidelity is 0.3 and the material's alpha 0.1"));
  numerics.fidelity = 0.0;
  EXPECT_EQ(problems_of(plate, numerics), "");
}

TEST(Numerics, ThePapersConstantsAreForPlaneStressAndAConstantMicromodulus) {
  Numerics numerics = test::numerics();
  numerics.constants = Constants::paper;
  EXPECT_EQ(problems_of(numerics), "");
  Plate thick = test::edge_crack(12e6);
  thick.plane = Plane::strain;
  EXPECT_THAT(problems_of(thick, numerics), HasSubstr("for plane stress"));
  numerics.micromodulus = Micromodulus::conical;
  EXPECT_THAT(problems_of(numerics), HasSubstr("a constant micromodulus"));
}

TEST(Numerics, NoProblemHidesAnother) {
  Numerics numerics = test::numerics();
  numerics.step = 240e-9;
  numerics.fidelity = 2.0;
  EXPECT_THAT(problems_of(numerics, 1000),
              testing::AllOf(HasSubstr("fidelity is 2"), HasSubstr("above the stability limit"),
                             HasSubstr("1.6e+04 nodes need")));
  numerics.horizon = 0.5e-3;
  numerics.step = -1.0;
  EXPECT_THAT(problems_of(numerics),
              testing::AllOf(HasSubstr("under 2 spacings"), HasSubstr("fidelity is 2"),
                             HasSubstr("step is -1 s")));
  numerics.spacing = 0.0;
  EXPECT_THAT(problems_of(numerics),
              testing::AllOf(HasSubstr("spacing is 0 m"), HasSubstr("fidelity is 2")));
}

TEST(Numerics, ConstantsThatOverflowOrVanishAreRefused) {
  for (const auto& [E, G0] : {std::pair{1e300, 200.0}, {65e9, 1e-320}, {1e-200, 1e200}}) {
    Plate plate = test::bare_plate(20, 10);
    plate.material.E = E;
    plate.material.G0 = G0;
    EXPECT_THAT(problems_of(plate, test::numerics()), HasSubstr("can express together")) << E;
  }
}

TEST(Numerics, ABadMaterialHasNoStepLimit) {
  Plate plate = test::edge_crack(12e6);
  plate.material.rho = 0.0;
  Numerics numerics = test::numerics();
  numerics.step = 1.0;
  EXPECT_EQ(problems_of(plate, numerics), "");  // check(plate) refuses it
}

TEST(Numerics, TheStepLimitIsThatOfTheStiffestAndTheLightestMaterial) {
  Plate plate = test::edge_crack(12e6);
  Numerics numerics = test::numerics();
  numerics.step = 130e-9;  // the limit of glass is 233 ns
  EXPECT_EQ(problems_of(plate, numerics), "");
  Material other = plate.material;
  other.E *= 2.0;
  plate.inclusions.push_back({rectangle({0.0, 0.0}, {0.01, 0.01}), other});
  EXPECT_EQ(problems_of(plate, numerics), "");
  other.E = 0.1 * plate.material.E;
  other.rho *= 0.5;
  plate.inclusions.push_back({rectangle({0.02, 0.0}, {0.03, 0.01}), other});
  EXPECT_THAT(problems_of(plate, numerics), HasSubstr("above the stability limit of 116"));
  EXPECT_DOUBLE_EQ(Lattice(plate, test::numerics()).step_limit,
                   0.5 * Lattice(test::edge_crack(12e6), test::numerics()).step_limit);
}

}  // namespace
}  // namespace hackle
