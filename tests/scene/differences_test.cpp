// SPDX-License-Identifier: MIT
#include "scene/differences.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "scene/plate.hpp"
#include "support/nouns.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

std::vector<std::string> texts(const Plate& one, const Plate& other) {
  std::vector<std::string> list;
  for (const auto& [path, left, right] : Differences(one, other).list())
    list.push_back(fmt::format("{}: {} against {}", path, left, right));
  return list;
}

using testing::ElementsAre;

TEST(Differences, OfOnePlateAreNone) {
  const Plate plate = test::edge_crack(12e6);
  EXPECT_THAT(texts(plate, plate), ElementsAre());
}

TEST(Differences, NameTheMemberByItsPathWithItsUnit) {
  Plate plate = test::edge_crack(12e6);
  plate.loads.tractions[1].stress = Vec2(0.0, -14e6);
  plate.cracks[0].points[1] = {60e-3, 20e-3};
  plate.material.E = 64e9;
  plate.loads.damping = 3.0;
  EXPECT_THAT(texts(test::edge_crack(12e6), plate),
              ElementsAre("material.E: 65 GPa against 64 GPa",
                          "cracks[1].points: (0 m, 20 mm) (50 mm, 20 mm) against (0 m, 20 mm) (60 "
                          "mm, 20 mm)",
                          "tractions[2].stress: (0 Pa, -12 MPa) against (0 Pa, -14 MPa)",
                          "damping: 0 1/s against 3 1/s"));
}

TEST(Differences, DoNotMindTheOrderOfLoads) {
  Plate plate = test::edge_crack(12e6);
  std::swap(plate.loads.tractions[0], plate.loads.tractions[1]);
  EXPECT_THAT(texts(test::edge_crack(12e6), plate), ElementsAre());
  // The traction on the top edge, wherever it stands.
  plate.loads.tractions[1].stress = Vec2(0.0, 14e6);
  EXPECT_THAT(texts(test::edge_crack(12e6), plate),
              ElementsAre("tractions[1].stress: (0 Pa, 12 MPa) against (0 Pa, 14 MPa)"));
  plate.loads.tractions.erase(plate.loads.tractions.begin());
  EXPECT_THAT(texts(test::edge_crack(12e6), plate),
              ElementsAre("tractions[1].stress: (0 Pa, 12 MPa) against (0 Pa, 14 MPa)",
                          "tractions[2]: edge bottom, stress (0 Pa, -12 MPa) against none"));
}

TEST(Differences, ShowWhatOnlyOneHas) {
  Plate plate = test::edge_crack(12e6);
  plate.cracks.clear();
  plate.contact = Contact{};
  const std::vector<std::string> list = texts(test::edge_crack(12e6), plate);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0], "cracks[1]: points (0 m, 20 mm) (50 mm, 20 mm) against none");
  EXPECT_TRUE(list[1].starts_with("contact: none against")) << list[1];
}

TEST(Differences, TellKindsAndShapesApart) {
  Plate one = test::edge_crack(12e6), other = one;
  Support support;
  support.value = Vec2(0.0, 1e-3);
  one.loads.supports.push_back(support);
  support.kind = Support::Kind::velocity;
  other.loads.supports.push_back(support);
  one.no_fail = {Ellipse{{0.0, 0.0}, {1e-3, 1e-3}}};
  other.no_fail = {Ellipse{{0.0, 0.0}, {1e-3, 2e-3}}, rectangle({0, 0}, {1, 1})};
  EXPECT_THAT(
      texts(one, other),
      ElementsAre(
          "no_fail[1].radii: (1 mm, 1 mm) against (1 mm, 2 mm)",
          "no_fail[2]: none against polygon points (0 m, 0 m) (1 m, 0 m) (1 m, 1 m) (0 m, 1 "
          "m)",
          "supports[1].displacement: (0 m, 1 mm) against velocity (0 m/s, 1 mm/s)"));
}

// Four digits hide it.
TEST(Differences, SeeTheLastBit) {
  Plate plate = test::edge_crack(12e6);
  plate.width = std::nextafter(0.1, 1.0);
  EXPECT_THAT(texts(test::edge_crack(12e6), plate),
              ElementsAre("width: 0.1 m against 0.10000000000000002 m"));
}

TEST(Differences, FunctionsThatReadAlikeAreEqual) {
  Plate one = test::edge_crack(12e6), other = one;
  one.loads.tractions[0].amplitude = Amplitude([](double t) { return t; }, "t");
  other.loads.tractions[0].amplitude = Amplitude([](double t) { return t; }, "t");
  EXPECT_THAT(texts(one, other), ElementsAre());
  other.loads.tractions[0].amplitude = Amplitude([](double t) { return t; }, "2*t");
  EXPECT_THAT(texts(one, other), ElementsAre("tractions[1].time: t against 2*t"));
}

// No member is forgotten: each value of a filled noun is another one.
TEST(Differences, SeeEveryMemberOfANoun) {
  Material one, other;
  test::NounFiller(1).fill_members<test::Everything>(one);
  test::NounFiller(2).fill_members<test::Everything>(other);
  EXPECT_EQ(Differences(one, other).list().size(),
            std::tuple_size_v<decltype(description_of<Material>.members)>);
}

}  // namespace
}  // namespace hackle
