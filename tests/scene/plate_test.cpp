// SPDX-License-Identifier: MIT
#include "scene/plate.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

std::string problems_of(const Plate& plate) {
  Problems problems;
  check(plate, problems);
  try {
    problems.throw_if_any();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Plate, ThePapersFirstPlateIsAccepted) {
  EXPECT_EQ(problems_of(test::edge_crack(12e6)), "");
}

TEST(Plate, SizesMustBePositiveAndFinite) {
  for (const double bad : {0.0, -0.1, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    Plate plate = test::bare_plate(10, 10);
    plate.width = bad;
    EXPECT_THAT(problems_of(plate), testing::HasSubstr("width is")) << bad;
  }
}

TEST(Plate, ACrackOffThePlateSaysWhereThePlateIs) {
  Plate plate = test::bare_plate(200, 80);
  plate.cracks.push_back({{0.0, 0.05}, {0.05, 0.02}, Born::broken});
  EXPECT_THAT(problems_of(plate),
              testing::AllOf(testing::HasSubstr("'from' (0 m, 50 mm) lies outside the plate"),
                             testing::HasSubstr("the plate is 100 mm x 40 mm")));
}

TEST(Plate, ACrackEndOnTheRimWithARoundingErrorIsOnThePlate) {
  Plate plate = test::bare_plate(200, 80);
  plate.cracks.push_back({{0.0, 0.02}, {0.1 + 1e-17, 0.02}, Born::broken});
  EXPECT_EQ(problems_of(plate), "");
}

TEST(Plate, ACrackOfNoLengthIsRefused) {
  Plate plate = test::bare_plate(200, 80);
  plate.cracks.push_back({{0.01, 0.01}, {0.01, 0.01}, Born::broken});
  EXPECT_THAT(problems_of(plate), testing::HasSubstr("same point"));
}

TEST(Plate, AllProblemsAreReportedTogether) {
  Plate plate = test::bare_plate(200, 80);
  plate.material.E = -1.0;
  plate.cracks.push_back({{-1.0, 0.0}, {0.0, 9.0}, Born::broken});
  plate.no_fail.push_back(rectangle({1.0, 1.0}, {2.0, 2.0}));
  const std::string text = problems_of(plate);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;
}

TEST(Plate, StripsLieAlongTheirEdges) {
  const Plate plate = test::bare_plate(200, 80);
  EXPECT_EQ(bounds(strip(plate, Edge::top, 2e-3)).min, Vec2(0.0, 0.04 - 2e-3));
  EXPECT_EQ(bounds(strip(plate, Edge::bottom, 2e-3)).max, Vec2(0.1, 2e-3));
  EXPECT_EQ(bounds(strip(plate, Edge::left, 2e-3)).max, Vec2(2e-3, 0.04));
  EXPECT_EQ(bounds(strip(plate, Edge::right, 2e-3)).min, Vec2(0.1 - 2e-3, 0.0));
}

TEST(Plate, EdgesAreKnownByName) {
  for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top})
    EXPECT_EQ(value_named<Edge>(name_of(edge)), edge);
  EXPECT_FALSE(value_named<Edge>("upper"));
}

TEST(Plate, DescriptionCountsWhatIsOnIt) {
  EXPECT_EQ(describe(test::edge_crack(12e6)),
            "plate 100 x 40 mm, Duran 50 glass (E 65 GPa, rho 2235 kg/m3, G0 204 J/m2), 1 crack, "
            "2 tractions, 2 no-fail zones");
}

TEST(Plate, DescriptionSaysPlaneStrain) {
  Plate plate = test::bare_plate(200, 80);
  plate.plane = Plane::strain;
  EXPECT_EQ(describe(plate),
            "plate 100 x 40 mm, plane strain, Duran 50 glass (E 65 GPa, rho 2235 kg/m3, G0 204 "
            "J/m2)");
}

TEST(Plate, ATemperatureNeedsAMaterialThatExpands) {
  Plate plate = test::edge_crack(12e6);
  plate.loads.thermal_loads.push_back({std::nullopt, 100.0, Amplitude()});
  EXPECT_THAT(problems_of(plate), testing::HasSubstr("does not expand, its alphaT is 0"));
  Material other = plate.material;
  other.alphaT = 9e-6;
  plate.inclusions.push_back({rectangle({0.0, 0.0}, {0.01, 0.01}), other});
  EXPECT_EQ(problems_of(plate), "");
}

TEST(Plate, HasSoManyMaterialsAtMost) {
  Plate plate = test::edge_crack(12e6);
  plate.inclusions.assign(1000, {rectangle({0.0, 0.0}, {0.01, 0.01}), plate.material});
  for (std::size_t k = 0; k < 254; ++k) plate.inclusions[k].material.G0 = 1.0 + double(k);
  plate.inclusions.resize(254);
  EXPECT_EQ(problems_of(plate), "");
  plate.inclusions.push_back(plate.inclusions.front());
  EXPECT_EQ(problems_of(plate), "");
  plate.inclusions.back().material.E *= 2.0;
  EXPECT_THAT(problems_of(plate), testing::HasSubstr("255 different materials"));
}

}  // namespace
}  // namespace hackle
