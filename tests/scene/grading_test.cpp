// SPDX-License-Identifier: MIT
#include "scene/grading.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "support/composite.hpp"

namespace hackle {
namespace {

ScalarField field(double (*function)(const Vec2&)) {
  return ScalarField(std::function<double(const Vec2&)>(function));
}

// The material at a place, as a node there takes it.
const Material& material_at(const std::vector<Inclusion>& inclusions, const Plate& plate,
                            const Vec2& place) {
  const Material* found = &plate.material;
  for (const Inclusion& inclusion : inclusions)
    if (covers(inclusion.shape, place, 1e-12)) found = &inclusion.material;
  return *found;
}

TEST(Gradings, RoundToLevelsOfTheRange) {
  const Plate plate = test::bare_plate(40, 20);  // 20 x 10 mm
  Grading grading{plate.material};
  grading.fields[0] = field([](const Vec2& at) { return 40e9 + 2e12 * at.x(); });  // 40 to 80 GPa
  grading.levels = 10;
  const std::vector<Inclusion> levels = make(plate, grading);
  EXPECT_EQ(levels.size(), 10U);
  for (double x = 0.3e-3; x < plate.width; x += 0.71e-3) {
    const Material& material = material_at(levels, plate, {x, 3.3e-3});
    // Half a level, and half a cell.
    EXPECT_NEAR(material.E, 40e9 + 2e12 * x, 0.05 * 40e9 + 0.5 * 2e12 * 20e-3 / 400.0 * 1.01);
    EXPECT_EQ(material.rho, plate.material.rho);
    EXPECT_EQ(material.G0, plate.material.G0);
  }
}

// Bit for bit: the inclusion that one would write oneself.
TEST(Gradings, OfTwoValuesAreAnInclusion) {
  const Plate plate = test::bare_plate(40, 20);
  Grading grading{plate.material};
  grading.cell = 0.5e-3;
  grading.fields[0] = field([](const Vec2& at) { return at.x() < 8e-3 ? 65e9 : 31.7e9; });
  grading.fields[1] = field([](const Vec2& at) { return at.x() < 8e-3 ? 2235.0 : 1201.3; });
  const std::vector<Inclusion> levels = make(plate, grading);
  ASSERT_EQ(levels.size(), 2U);
  Material soft = plate.material;
  soft.E = 31.7e9;
  soft.rho = 1201.3;
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 40; ++i)
      EXPECT_EQ(material_at(levels, plate, {(i + 0.5) * 0.5e-3, (j + 0.5) * 0.5e-3}),
                i < 16 ? plate.material : soft);
}

TEST(Gradings, OfStrengthKeepTheStiffnessAndGoWithTheSquare) {
  const Plate plate = test::bare_plate(40, 20);
  Grading grading{plate.material};
  grading.fields[3] = field([](const Vec2& at) { return at.y() < 5e-3 ? 1.0 : 0.5; });
  EXPECT_EQ(material_at(make(plate, grading), plate, {5e-3, 8e-3}).G0, 0.25 * plate.material.G0);
  EXPECT_EQ(material_at(make(plate, grading), plate, {5e-3, 8e-3}).E, plate.material.E);
  grading.material.G0 = 0.0;
  grading.material.s0 = 2e-3;
  EXPECT_EQ(material_at(make(plate, grading), plate, {5e-3, 8e-3}).s0, 1e-3);
}

TEST(Gradings, StayInTheirArea) {
  const Plate plate = test::bare_plate(40, 20);
  Grading grading{test::steel(), test::disc({10e-3, 5e-3}, 3e-3)};
  grading.fields[1] = field([](const Vec2& at) { return 7000.0 + 1e5 * at.y(); });
  const std::vector<Inclusion> levels = make(plate, grading);
  EXPECT_EQ(material_at(levels, plate, {5e-3, 5e-3}), plate.material);
  EXPECT_EQ(material_at(levels, plate, {10e-3, 5e-3}).E, test::steel().E);
  EXPECT_NEAR(material_at(levels, plate, {10e-3, 5e-3}).rho, 7500.0, 0.05 * 600.0);
}

TEST(Gradings, RefuseWhatIsNoMaterialAndTooMany) {
  const Plate plate = test::bare_plate(40, 20);
  const auto expect_refused = [&](const Grading& grading, const char* part) {
    try {
      make(plate, grading);
      FAIL() << part;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  Grading grading{plate.material};
  grading.fields[0] = field([](const Vec2& at) { return 1e9 - 1e11 * at.x(); });
  expect_refused(grading, "grade: E is");
  grading.fields[0] = field([](const Vec2& at) { return 1e9 + 1e11 * at.x(); });
  grading.fields[1] = field([](const Vec2& at) { return 1e3 + 1e5 * at.y(); });
  grading.levels = 100;
  expect_refused(grading, "pairs of levels");
  Problems problems;
  check(plate, Grading{plate.material, {}, {}, 16, 1e-7}, problems);
  EXPECT_EQ(problems.list().size(), 2U);  // too many cells, and nothing is graded
}

}  // namespace
}  // namespace hackle
