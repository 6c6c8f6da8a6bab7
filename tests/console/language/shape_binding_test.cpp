// SPDX-License-Identifier: MIT
#include "console/language/shape_binding.hpp"

#include <fstream>

#include <gmock/gmock.h>

#include "base/image.hpp"
#include "console/scripts.hpp"
#include "render/png.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

struct Case {
  const char* call;
  const char* message;
};

TEST(ShapeBinding, EveryWayToSayAShapeIsTaken) {
  EXPECT_EQ(
      test::message_of(
          test::plate_p +
          "p:hole { centre = {20*mm, 20*mm}, radius = 5*mm, name = 'bore' }\n"
          " :hole { centre = {40*mm, 20*mm}, radii = {5*mm, 2*mm}, angle = 30*deg }\n"
          " :hole { points = {{50*mm, 5*mm}, {60*mm, 5*mm}, {55*mm, 20*mm}} }\n"
          " :hole { from = {70*mm, 10*mm}, to = {80*mm, 20*mm}, width = 2*mm }\n"
          " :hole { centre = {20*mm, 33*mm}, radius = 3*mm, corners = 6 }\n"
          " :hole { centre = {40*mm, 33*mm}, radius = 3*mm, inner = 1*mm, corners = 5, angle = "
          "90*deg "
          "}\n"
          " :notch { at = {0, 20*mm}, depth = 5*mm, width = 1*mm, shape = 'u', angle = 0.2 }\n"
          " :inclusion { material = 'duran50', centre = {90*mm, 20*mm}, radius = 2*mm }\n"
          " :crack { points = {{0, 0}, {1*mm, 1*mm}, {2*mm, 0}} }\n"
          " :crack { centre = {50*mm, 30*mm}, radius = 3*mm, angles = {0, 360*deg} }\n"
          " :random_cracks { count = 3, length = {1*mm, 2*mm}, seed = -7 }\n"
          "assert(tostring(p):find('7 cut-outs, 1 inclusion, 5 cracks', 1, true), tostring(p))"),
      "");
}

// Nodes are counted by their fragments: s.nodes counts void ones, too.
TEST(ShapeBinding, APlateIsCutToItsOutline) {
  EXPECT_EQ(test::message_of(R"(
    local d = plate { outline = { centre = {25*mm, 25*mm}, radius = 25*mm }, material = 'duran50' }
    assert(math.abs(d.width - 50*mm) < 1e-9 and math.abs(d.height - 50*mm) < 1e-9)
    local nodes = simulate(d, { spacing = 0.5*mm }):fragments()[1].nodes
    assert(math.abs(nodes / (math.pi * 50^2) - 1) < 0.01, 'nodes: ' .. nodes)
    d:keep { points = {{0, 0}, {50*mm, 0}, {50*mm, 25*mm}, {0, 25*mm}} }
    assert(math.abs(simulate(d, { spacing = 0.5*mm }):fragments()[1].nodes / nodes - 0.5) < 0.01)
    assert(tostring(d):find('2 outlines', 1, true), tostring(d))
  )"),
            "");
}

TEST(ShapeBinding, SeveralAreasAreKeptTogether) {
  EXPECT_EQ(test::message_of(test::plate_p + R"(
    p:keep { any = { { centre = {20*mm, 20*mm}, radius = 10*mm, inner = 5*mm },
                     { from = {60*mm, 20*mm}, to = {80*mm, 20*mm}, width = 10*mm } }, name = 'rim' }
    local s = simulate(p, { spacing = 0.25*mm, horizon = 0.75*mm })
    local slot, ring = s:fragments()[1].nodes * 0.25^2, s:fragments()[2].nodes * 0.25^2
    assert(#s:fragments() == 2)
    assert(math.abs(slot / (20*10 + math.pi * 5^2) - 1) < 0.02, 'slot: ' .. slot)
    assert(math.abs(ring / (math.pi * (10^2 - 5^2)) - 1) < 0.02, 'ring: ' .. ring)
    p:pressure { rim = 'rim', pressure = 1*MPa }
    simulate(p, { spacing = 0.5*mm }):run(1*us)
  )"),
            "");
}

TEST(ShapeBinding, AnOutlineAwayFromTheOriginNeedsSizes) {
  const char* const plate = "plate { outline = { centre = {30*mm, 25*mm}, radius = 25*mm }, ";
  EXPECT_THAT(test::message_of(std::string(plate) + "material = 'duran50' }"),
              HasSubstr("the outline begins at (5 mm, 0 m)"));
  EXPECT_EQ(test::message_of(std::string(plate) + "width = 60*mm, height = 50*mm, material = "
                                                  "'duran50' }"),
            "");
}

TEST(ShapeBinding, WhatMakesNoSenseIsRefusedByName) {
  for (const Case& bad : {
           Case{"hole { }", "hole: the shape is not clear"},
           {"hole { centre = {0, 0} }",
            "give centre, radius; or centre, radii and maybe angle; or"},
           {"hole { centre = {0, 0}, radius = 1*mm, width = 1*mm }", "the shape is not clear"},
           {"hole { centre = {0, 0}, radius = 1*mm, angle = 1 }", "the shape is not clear"},
           {"hole { centre = {0, 0}, radius = 1*mm, corners = 2 }", "between 3 and 1000"},
           {"hole { centre = {0, 0}, radius = 1*mm, inner = 0, corners = 5 }", "inner is 0 m"},
           {"hole { centre = {50*mm, 20*mm}, radius = 1*mm, inner = 1*mm }",
            "inner is below radius"},
           {"keep { }", "keep: the shape is not clear"},
           {"keep { centre = {1, 1}, radius = 1*mm }", "lies outside the plate"},
           {"keep { any = {}, name = 'a' }", "the shape is not clear"},
           {"keep { any = { centre = {0, 0}, radius = 1*mm }, radius = 1*mm }",
            "any and another area are given"},
           {"keep { any = { 5 } }", "holds 5, expected an area"},
           {"hole { centre = {0, 0}, radius = 0 }", "radius is 0 m, it must be above 0 m"},
           {"hole { centre = {0, 0}, radius = 0/0 }", "radius is nan"},
           {"hole { centre = {0, 0}, radius = 1/0 }", "expected a finite number"},
           {"hole { centre = {0, 1/0}, radius = 1 }", "expected finite numbers"},
           {"hole { centre = {0, 0}, radii = {1*mm, -1*mm} }", "both must be above 0 m"},
           {"hole { centre = {0, 0}, radii = {1*mm} }", "radii is not a pair of numbers"},
           {"hole { centre = {0, 0}, radii = 3 }", "radii is 3, expected {a, b}"},
           {"hole { points = {} }", "points has 0 points"},
           {"hole { points = {{0, 0}, {1, 1}} }", "points has 2 points"},
           {"hole { points = {{0, 0}, {1, 1}, 3} }", "point 3 of points is not {x, y}"},
           {"hole { points = {{0, 0}, {1, 1}, {0/0, 1}} }", "point 3 of points"},
           {"hole { points = {{0, 0}, {1, 1}, {1, 2, 3}} }", "point 3 of points"},
           {"hole { points = {{0, 0}, {1, 1}, {2, 3}, x = 1} }", "something that is no point"},
           {"hole { points = {{0, 0}, {1*mm, 1*mm}, {2*mm, 2*mm}} }", "has no area"},
           {"hole { points = 'star' }", "cannot read 'star': no such file"},
           {"hole { centre = {1, 1}, radius = 1*mm }", "lies outside the plate"},
           {"hole { centre = {50*mm, 20*mm}, radius = 1 }", "leaves nothing of the plate"},
           {"hole { centre = {0, 0}, radius = 1*mm, name = 3 }", "name is 3, expected a text"},
           {"hole { centre = {1e308, 0}, radius = 1e308 }", "has no area"},
           {"notch { at = {50*mm, 20*mm}, depth = 1*mm, width = 1*mm }", "inside the plate"},
           {"notch { at = {-1, 20*mm}, depth = 1*mm, width = 1*mm }", "lies outside the plate"},
           {"notch { at = {0, 20*mm}, depth = 1*mm, width = 50*mm, shape = 'v' }", "so oblique"},
           {"notch { at = {0, 20*mm}, depth = 1*mm, width = 1*mm, angle = 2 }", "between -1.4"},
           {"notch { at = {0, 20*mm}, width = 1*mm }", "depth is missing"},
           {"notch { at = {0, 0}, depth = 1*mm, width = 1*mm, shape = 'w' }", "one of slot, v, u"},
           {"crack { from = {0, 0} }",
            "give from, to; or points and maybe unit; or centre, radius, angles"},
           {"crack { points = {{0, 0}, {0, 0}, {1*mm, 0}} }", "two points in a row are the same"},
           {"crack { points = {{0, 0}, {1, 1}} }", "lies outside the plate"},
           {"crack { centre = {0.05, 0.02}, radius = 1*mm, angles = {0, 0} }", "goes 0 degrees"},
           {"crack { centre = {0.05, 0.02}, radius = 1*mm, angles = {0, 9} }", "at most 360*deg"},
           {"random_cracks { count = 0, length = {1, 2} }", "count is 0, it must be between 1"},
           {"random_cracks { count = 1e9, length = {1, 2} }", "count is 1000000000"},
           {"random_cracks { count = 1, length = {2, 1} }", "the least length is above the most"},
           {"random_cracks { count = 1, length = {1, 2} }", "do not fit into the area"},
           {"random_cracks { count = 1, length = {1*mm, 2*mm}, from = {0, 0} }", "given together"},
           {"random_cracks { count = 1, length = {1*mm, 2*mm}, from = {0, 0}, to = {1, 1} }",
            "reaches beyond the plate"},
           {"inclusion { centre = {0, 0}, radius = 1*mm }", "material is missing"},
           {"inclusion { material = 'cheese', centre = {0, 0}, radius = 1*mm }", "cheese"},
           {"mask { 'nowhere.png' }", "cannot read the picture 'nowhere.png'"},
           {"mask { '.' }", "it is a folder"},
           {"mask { '/' }", "lies outside of what a script may read"},
           {"mask { 'a.png', threshold = 2 }", "threshold is 2"},
           {"mask { 'a.png', from = {1, 1}, to = {0, 0} }", "the area is empty"},
       })
    EXPECT_THAT(test::message_of(test::plate_p + "p:" + bad.call), HasSubstr(bad.message))
        << bad.call;
}

// Makes a picture of four pixels: black in the upper left corner, white elsewhere.
std::string corner_png(const std::filesystem::path& folder) {
  Image image(2, 2);
  std::ranges::fill(image.pixels, std::uint8_t{255});
  std::fill_n(image.pixels.begin(), 3, std::uint8_t{0});
  write_png(image, folder / "corner.png");
  return (folder / "corner.png").string();
}

TEST(ShapeBinding, AMaskRemovesItsDarkPixels) {
  const test::Folder folder;
  const std::string file = corner_png(folder.path);
  EXPECT_EQ(
      test::message_of(test::plate_p + "p:mask { '" + file +
                           "', name = 'corner' }\n"
                           "local s = simulate(p, { spacing = 1*mm, horizon = 2*mm })\n"
                           "assert(s:report():find('4 000 nodes (3 000 of material)', 1, true), "
                           "s:report())",
                       test::quiet(folder.path)),
      "");
  EXPECT_EQ(
      test::message_of(test::plate_p + "p:mask { '" + file +
                           "', remove = 'light' }\n"
                           "local s = simulate(p, { spacing = 1*mm, horizon = 2*mm })\n"
                           "assert(s:report():find('(1 000 of material)', 1, true), s:report())",
                       test::quiet(folder.path)),
      "");
}

TEST(ShapeBinding, AMaskWithAMaterialIsAnInclusion) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(test::plate_p + "p:mask { '" + corner_png(folder.path) +
                                 "', material = 'duran50' }\n"
                                 "assert(tostring(p):find('1 inclusion', 1, true))",
                             test::quiet(folder.path)),
            "");
}

TEST(ShapeBinding, APictureThatIsCutOffIsRefused) {
  const test::Folder folder;
  const std::string file = corner_png(folder.path);
  std::filesystem::resize_file(file, 50);
  EXPECT_THAT(
      test::message_of(test::plate_p + "p:mask { '" + file + "' }", test::quiet(folder.path)),
      HasSubstr("cannot read the picture"));
  std::ofstream(file) << "this is no picture at all";
  EXPECT_THAT(
      test::message_of(test::plate_p + "p:mask { '" + file + "' }", test::quiet(folder.path)),
      HasSubstr("cannot read the picture"));
}

}  // namespace
}  // namespace hackle
