// SPDX-License-Identifier: MIT
// scripts/dxf.lua: drawings as outlines and holes.
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/files.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// Groups of a DXF: "0 LINE 8 cut 10 0 ..." with one code and one value in turn.
std::string drawing(const std::string& groups, int insunits = 4) {
  std::string text =
      fmt::format("0 SECTION 2 HEADER 9 $INSUNITS 70 {} 0 ENDSEC 0 SECTION 2 ENTITIES ", insunits);
  text += groups + " 0 ENDSEC 0 EOF ";
  for (char& c : text)
    if (c == ' ') c = '\n';
  return text;
}

// 50 x 30 with half a disc of radius 15 at its right, which begins at (10, 0).
const std::string rounded =
    "0 LWPOLYLINE 8 cut 70 1 10 10 20 0 10 60 20 0 42 1 10 60 20 30 10 10 20 30";

class Drawing : public testing::Test {
 protected:
  std::string message(const std::string& dxf, const std::string& script,
                      const std::string& options = "") {
    write_text(folder_.path / "a.dxf", dxf);
    return test::message_of("part = require 'dxf' { 'a.dxf', " + options + " } " + script,
                            test::quiet(folder_.path));
  }
  test::Folder folder_;
};

TEST_F(Drawing, HasItsAreaAndSize) {
  const std::string holes =
      " 0 CIRCLE 8 cut 10 25 20 15 40 5 0 ELLIPSE 8 cut 10 60 20 15 11 0 21 6 40 0.5 "
      "0 LINE 8 cut 10 40 20 5 11 50 21 5 0 ARC 8 cut 10 45 20 5 40 5 50 0 51 180 0 TEXT 8 cut 1 x";
  const double pi = std::numbers::pi;
  const double area = 50 * 30 + pi * 15 * 15 / 2 - pi * 25 - pi * 6 * 3 - pi * 25 / 2;
  EXPECT_EQ(message(drawing(rounded + holes), fmt::format(R"(
    assert(#part.holes == 3)
    p = plate {{ outline = part.outline, material = 'pmma' }}
    assert(math.abs(p.width - 65*mm) < 1e-6 and math.abs(p.height - 30*mm) < 1e-9)
    for _, hole in ipairs(part.holes) do p:hole(hole) end
    local found = simulate(p, {{ spacing = 0.25*mm }}):fragments()[1].nodes/16
    assert(math.abs(found/{:.17g} - 1) < 0.005, found))",
                                                          area)),
            "");
}

// Lines in any order and direction, and a polyline of vertices.
TEST_F(Drawing, IsJoinedFromPieces) {
  EXPECT_EQ(message(drawing("0 LINE 8 a 10 0 20 0 11 4 21 0 0 LINE 8 a 10 0 20 3 11 4 21 3 "
                            "0 LINE 8 a 10 0 20 0 11 0 21 3 0 LINE 8 a 10 4 20 3 11 4 21 0 "
                            "0 POLYLINE 8 a 70 1 0 VERTEX 10 1 20 1 0 VERTEX 10 2 20 1 "
                            "0 VERTEX 10 2 20 2 0 SEQEND"),
                    "assert(#part.outline.points == 4 and #part.holes[1].points == 3)"),
            "");
}

TEST_F(Drawing, TakesItsUnitFromTheHeaderOrTheScript) {
  const char* const script = "assert(math.abs(part.outline.radius/(%s) - 1) < 1e-12)";
  const auto radius = [&](int insunits, const char* options, const char* expected) {
    const std::string text = script;
    return message(drawing("0 CIRCLE 8 a 10 0 20 0 40 2", insunits),
                   text.substr(0, text.find("%s")) + expected + text.substr(text.find("%s") + 2),
                   options);
  };
  EXPECT_EQ(radius(4, "", "2*mm"), "");
  EXPECT_EQ(radius(1, "", "50.8*mm"), "");
  EXPECT_EQ(radius(0, "unit = cm", "2*cm"), "");
  EXPECT_THAT(radius(0, "", "1"), HasSubstr("does not say its unit"));
}

TEST_F(Drawing, IsReadByLayers) {
  const std::string two = rounded + " 0 SPLINE 8 marks 70 0 0 CIRCLE 8 other 10 500 20 500 40 1";
  EXPECT_EQ(message(drawing(two), "assert(#part.holes == 0)", "layers = { 'cut' }"), "");
  EXPECT_THAT(message(drawing(two), "", "layers = { 'cut', 'cuts' }"),
              HasSubstr("nothing on layer 'cuts'; its layers are cut, marks, other"));
  EXPECT_THAT(message(drawing(two), ""), HasSubstr("SPLINE is not read"));
  EXPECT_THAT(message(drawing(two), "", "layers = { 'cut', 'other' }"),
              HasSubstr("outside of the largest one"));
}

TEST_F(Drawing, IsRefusedWithTheLine) {
  const auto refused = [&](const std::string& groups) { return message(drawing(groups), ""); };
  EXPECT_THAT(refused("0 LINE 8 a 10 0 20 0 11 4 21 0 0 LINE 8 a 10 4 20 0 11 4 21 3"),
              HasSubstr("line 16: the loop that begins here stays open at (4, 3)"));
  EXPECT_THAT(refused("0 CIRCLE 8 a 10 nan"), HasSubstr("line 20: a finite number"));
  EXPECT_THAT(refused("0 CIRCLE 8 a 10 1 20 1"), HasSubstr("CIRCLE has no group 40"));
  EXPECT_THAT(refused("0 CIRCLE 8 a 10 0 20 0 40 2 210 0 220 0 230 -1"),
              HasSubstr("another plane"));
  EXPECT_THAT(refused("0 TEXT 8 a 1 x"), HasSubstr("has no loop"));
  EXPECT_THAT(message("hello\nworld\n", ""), HasSubstr("line 1: is no DXF"));
  EXPECT_THAT(message("", ""), HasSubstr("empty"));
  EXPECT_THAT(message(drawing(rounded).substr(0, 100), ""), HasSubstr("cut off"));
  EXPECT_THAT(message("AutoCAD Binary DXF\r\n", ""), HasSubstr("binary"));
  EXPECT_THAT(test::message_of("require 'dxf' { '/dev/zero' }"), HasSubstr("outside of what"));
}

}  // namespace
}  // namespace hackle
