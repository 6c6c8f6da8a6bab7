// SPDX-License-Identifier: MIT
// Every option of every function that describes something must reach the member that it names:
// compares scripts in which all values differ with the resulting scene.
#include <numbers>
#include <set>
#include <string>

#include <gmock/gmock.h>

#include "console/language/load_docs.hpp"
#include "console/language/material_binding.hpp"
#include "console/language/plate_binding.hpp"
#include "console/language/scripted_material.hpp"
#include "console/language/scripted_plate.hpp"
#include "console/language/scripted_run.hpp"
#include "console/language/shape_docs.hpp"
#include "console/language/simulation_binding.hpp"
#include "console/language/simulation_docs.hpp"
#include "console/language/units_binding.hpp"
#include "console/reference/vocabulary.hpp"
#include "console/schema/object_type.hpp"
#include "console/scripts.hpp"
#include "render/png.hpp"
#include "scene/random_cracks.hpp"

namespace hackle {
namespace {

constexpr double pi = std::numbers::pi;

class Members : public testing::Test {
 protected:
  Members() : session_(test::quiet()) {
    set_session(L, &session_);
    open_errors(L);
    open_units(L);
    open_type(L, type_name<Material>, material_type());
    open_type(L, type_name<Plate>, plate_type());
    open_type(L, type_name<ScriptedRun>, simulation_type());
    luaL_openlibs(L);
    open_functions(L, all_functions());
  }

  void run(const std::string& script) {
    ASSERT_EQ(luaL_loadstring(L, script.c_str()), LUA_OK) << lua_tostring(L, -1);
    protected_call(L, 0, 0);
  }

  // Returns the plate of 100 x 40 mm with a hole "bore", of a material that expands, after `calls`.
  const Plate& plate_after(const std::string& calls) {
    run("p = plate { width = 100*mm, height = 40*mm, material = material { like = 'duran50', "
        "alphaT = 3e-6 } }\n"
        "p:hole { centre = {80*mm, 20*mm}, radius = 3*mm, name = 'bore' }\n" +
        calls);
    lua_getglobal(L, "p");
    return *object_at<Plate>(L, -1);
  }

  // Reads the options of a picture or a movie, in braces.
  Arguments arguments(const std::string& options, const FunctionDoc& doc) {
    EXPECT_EQ(luaL_loadstring(L, ("return " + options).c_str()), LUA_OK);
    protected_call(L, 0, 1);
    Arguments read = Arguments::from_table(L, lua_gettop(L), doc);
    EXPECT_TRUE(read.problems.empty());
    return read;
  }

  Session session_;
  LuaState L;
};

// An option added to a table must also be added to the script that tests it.
void expect_all_named(const FunctionDoc& doc, const std::string& script) {
  for (const Option& option : doc.options) {
    EXPECT_TRUE(option.positional ||
                script.find(std::string(option.name) + " =") != std::string::npos)
        << doc.name << ": " << option.name;
  }
}

void expect_box(const Region& region, const Vec2& min, const Vec2& max) {
  ASSERT_TRUE(region);
  const Box box = bounds(*region);
  EXPECT_NEAR((box.min - min).norm(), 0.0, 1e-15);
  EXPECT_NEAR((box.max - max).norm(), 0.0, 1e-15);
}

TEST_F(Members, OfAMaterial) {
  const std::string script =
      "m = material { name = 'slate', E = 1*GPa, rho = 2, nu = 0.3, G0 = 4, alpha = 0.05, alphaT = "
      "6e-6, fringe = 7, c = 8e20 }\n"
      "n = material { like = m, s0 = 0.08 }";
  expect_all_named(*material_functions().front().doc, script);
  run(script);
  lua_getglobal(L, "m");
  const Material& m = *object_at<Material>(L, -1);
  EXPECT_EQ(m, (Material{"slate", 1e9, 2.0, 0.3, 4.0, 0.05, 6e-6, 7.0, 0.0, 8e20}));
  lua_getglobal(L, "n");
  const Material& n = *object_at<Material>(L, -1);
  EXPECT_EQ(n, (Material{"like slate", 1e9, 2.0, 0.3, 0.0, 0.05, 6e-6, 7.0, 0.08, 8e20}));
}

TEST_F(Members, OfAPlate) {
  run("p = plate { width = 30*mm, height = 20*mm, material = 'soda_lime', plane = 'strain' }");
  lua_getglobal(L, "p");
  const Plate& plate = *object_at<Plate>(L, -1);
  EXPECT_EQ(plate.width, 30e-3);
  EXPECT_EQ(plate.height, 20e-3);
  EXPECT_EQ(plate.material.G0, 3.8);
  EXPECT_EQ(plate.plane, Plane::strain);
}

TEST_F(Members, OfHoles) {
  const std::string calls =
      "p:hole { centre = {11*mm, 12*mm}, radius = 3*mm, name = 'a', bonds = 'keep' }\n"
      "p:hole { centre = {21*mm, 22*mm}, radii = {3*mm, 2*mm}, angle = 0.5, name = 'b' }\n"
      "p:hole { points = {{31, 1}, {35, 2}, {33, 6}}, unit = mm }\n"
      "p:hole { from = {41*mm, 11*mm}, to = {45*mm, 12*mm}, width = 3*mm, name = 'd' }\n"
      "p:hole { centre = {51*mm, 12*mm}, radius = 3*mm, corners = 6, angle = 0.2 }\n"
      "p:hole { centre = {61*mm, 12*mm}, radius = 4*mm, inner = 2*mm, corners = 5 }";
  expect_all_named(hole_doc, calls);
  const Plate& plate = plate_after(calls);
  ASSERT_EQ(plate.cutouts.size(), 7U);
  EXPECT_EQ(plate.cutouts[0].name, "bore");
  EXPECT_EQ(plate.cutouts[1].name, "a");
  EXPECT_EQ(plate.cutouts[1].bonds, Bridging::keep);
  EXPECT_EQ(plate.cutouts[2].bonds, Bridging::cut);
  EXPECT_EQ(plate.cutouts[1].shape, Shape(Ellipse{{0.011, 0.012}, {3e-3, 3e-3}, 0.0}));
  EXPECT_EQ(plate.cutouts[2].name, "b");
  EXPECT_EQ(plate.cutouts[2].shape, Shape(Ellipse{{0.021, 0.022}, {3e-3, 2e-3}, 0.5}));
  EXPECT_EQ(plate.cutouts[3].name, "");
  EXPECT_EQ(plate.cutouts[3].shape,
            Shape(Polygon{{{31 * 1e-3, 1e-3}, {35 * 1e-3, 2e-3}, {33 * 1e-3, 6e-3}}}));
  EXPECT_EQ(plate.cutouts[4].name, "d");
  const auto* slot = std::get_if<Capsule>(&plate.cutouts[4].shape);
  ASSERT_NE(slot, nullptr);
  EXPECT_NEAR((slot->axis.from - Vec2(41e-3, 11e-3)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((slot->axis.to - Vec2(45e-3, 12e-3)).norm(), 0.0, 1e-15);
  EXPECT_EQ(slot->radius, 1.5e-3);
  EXPECT_EQ(plate.cutouts[5].shape, Shape(star({51 * 1e-3, 12 * 1e-3}, 3 * 1e-3, 6, 0.2)));
  EXPECT_EQ(plate.cutouts[6].shape,
            Shape(star({61 * 1e-3, 12 * 1e-3}, 4 * 1e-3, 5, 0.0, 2 * 1e-3)));
}

TEST_F(Members, OfOutlines) {
  const Plate& plate = plate_after(
      "p:keep { centre = {11*mm, 12*mm}, radius = 30*mm, inner = 1*mm, name = 'a' }\n"
      "p:keep { any = { centre = {11*mm, 12*mm}, radius = 3*mm } }\n"
      "p:keep { any = { { centre = {11*mm, 12*mm}, radius = 3*mm },\n"
      "                 { points = {{1*mm, 1*mm}, {5*mm, 2*mm}, {3*mm, 6*mm}} } }, name = 'c' }");
  const Shape disc = Ellipse{{11 * 1e-3, 12 * 1e-3}, {3 * 1e-3, 3 * 1e-3}, 0.0};
  ASSERT_EQ(plate.outlines.size(), 3U);
  EXPECT_EQ(plate.outlines[0].areas,
            std::vector<Shape>{(Ring{{11 * 1e-3, 12 * 1e-3}, 30 * 1e-3, 1e-3})});
  EXPECT_EQ(plate.outlines[0].name, "a");
  EXPECT_EQ(plate.outlines[1].areas, std::vector<Shape>{disc});
  EXPECT_EQ(plate.outlines[2].areas,
            (std::vector<Shape>{
                disc, Polygon{{{1e-3, 1e-3}, {5 * 1e-3, 2 * 1e-3}, {3 * 1e-3, 6 * 1e-3}}}}));
  EXPECT_EQ(plate.outlines[2].name, "c");
}

TEST_F(Members, OfInclusions) {
  const std::string calls =
      "p:inclusion { centre = {21*mm, 22*mm}, radii = {3*mm, 2*mm}, angle = -0.5, material = "
      "'soda_lime' }\n"
      "p:inclusion { centre = {11*mm, 12*mm}, radius = 1*mm, material = 'alumina' }\n"
      "p:inclusion { points = {{31, 1}, {35, 2}, {33, 6}}, unit = mm, material = 'pmma' }\n"
      "p:inclusion { from = {41*mm, 11*mm}, to = {45*mm, 12*mm}, width = 2*mm, material = 'pmma' "
      "}\n"
      "p:inclusion { centre = {61*mm, 12*mm}, radius = 4*mm, inner = 2*mm, corners = 5, material = "
      "'pmma' }";
  expect_all_named(inclusion_doc, calls);
  const Plate& plate = plate_after(calls);
  ASSERT_EQ(plate.inclusions.size(), 5U);
  EXPECT_EQ(plate.inclusions[0].shape, Shape(Ellipse{{0.021, 0.022}, {3e-3, 2e-3}, -0.5}));
  EXPECT_EQ(plate.inclusions[0].material.G0, 3.8);
  EXPECT_EQ(plate.inclusions[1].material.alphaT, 7.5e-6);
  EXPECT_TRUE(std::holds_alternative<Polygon>(plate.inclusions[2].shape));
  EXPECT_TRUE(std::holds_alternative<Capsule>(plate.inclusions[3].shape));
  EXPECT_EQ(std::get<Polygon>(plate.inclusions[4].shape).points.size(), 10U);
}

// Four pixels of four shades: black and dark grey above, light grey and white below.
TEST_F(Members, OfMasks) {
  const test::Folder folder;
  session_.settings.output_folder = folder.path;
  Image image(2, 2);
  const std::uint8_t shades[] = {0, 100, 180, 255};
  for (std::size_t k = 0; k < 16; ++k) image.pixels[k] = k % 4 == 3 ? 255 : shades[k / 4];
  write_png(image, folder.path / "m.png");
  const std::string calls =
      "p:mask { 'm.png', from = {10*mm, 12*mm}, to = {30*mm, 22*mm}, name = 'a' }\n"
      "p:mask { 'm.png', remove = 'light' }\n"
      "p:mask { 'm.png', threshold = 0.2 }\n"
      "p:mask { 'm.png', threshold = 0.8, material = 'alumina' }";
  expect_all_named(mask_doc, calls);
  const Plate& plate = plate_after(calls);
  ASSERT_EQ(plate.cutouts.size(), 4U);
  ASSERT_EQ(plate.inclusions.size(), 1U);
  using Cells = std::vector<std::uint8_t>;  // row by row from below
  const auto bitmap = [](const Shape& shape) { return std::get<Bitmap>(shape); };
  EXPECT_EQ(bitmap(plate.cutouts[1].shape).inside, (Cells{0, 0, 1, 1}));
  EXPECT_EQ(bitmap(plate.cutouts[2].shape).inside, (Cells{1, 1, 0, 0}));
  EXPECT_EQ(bitmap(plate.cutouts[3].shape).inside, (Cells{0, 0, 1, 0}));
  EXPECT_EQ(bitmap(plate.inclusions[0].shape).inside, (Cells{1, 0, 1, 1}));
  EXPECT_EQ(plate.inclusions[0].material.alphaT, 7.5e-6);
  EXPECT_EQ(plate.cutouts[1].name, "a");
  EXPECT_EQ(plate.cutouts[2].name, "");
  expect_box(plate.cutouts[1].shape, {10e-3, 12e-3}, {30e-3, 22e-3});
  expect_box(plate.cutouts[2].shape, {0, 0}, {0.1, 0.04});
}

TEST_F(Members, OfNotches) {
  const std::string calls =
      "p:notch { at = {0, 11*mm}, depth = 8*mm, width = 2*mm, shape = 'u', angle = 0.4, name = 'n' "
      "}\n"
      "p:notch { at = {100*mm, 9*mm}, depth = 7*mm, width = 3*mm, shape = 'v', angle = -0.2 }\n"
      "p:notch { at = {50*mm, 40*mm}, depth = 6*mm, width = 1*mm }";
  expect_all_named(notch_doc, calls);
  const Plate& plate = plate_after(calls);
  ASSERT_EQ(plate.cutouts.size(), 4U);
  const Notch notches[] = {{{0.0, 11e-3}, 8e-3, 2e-3, Notch::Kind::u, 0.4},
                           {{0.1, 9e-3}, 7e-3, 3e-3, Notch::Kind::v, -0.2},
                           {{0.05, 0.04}, 6e-3, 1e-3, Notch::Kind::slot, 0.0}};
  for (std::size_t k = 0; k < 3; ++k) {
    const Box found = bounds(plate.cutouts[k + 1].shape),
              wanted = bounds(shape_of(notches[k], plate));
    EXPECT_EQ(plate.cutouts[k + 1].shape.index(), shape_of(notches[k], plate).index()) << k;
    EXPECT_NEAR((found.min - wanted.min).norm() + (found.max - wanted.max).norm(), 0.0, 1e-12) << k;
  }
  EXPECT_EQ(plate.cutouts[1].name, "n");
  EXPECT_EQ(plate.cutouts[2].name, "");
}

TEST_F(Members, OfCracks) {
  const std::string calls =
      "p:crack { from = {1*mm, 2*mm}, to = {3*mm, 4*mm}, born = 'absent', "
      "name = 'slit' }\n"
      "p:crack { points = {{5, 6}, {7, 8}, {9, 1}}, unit = mm }\n"
      "p:crack { centre = {40*mm, 20*mm}, radius = 5*mm, angles = {90*deg, 180*deg}, ends = 'cut' "
      "}";
  expect_all_named(crack_doc, calls);
  const Plate& plate = plate_after(calls);
  ASSERT_EQ(plate.cracks.size(), 3U);
  const auto near = [](const Vec2& one, const Vec2& other) { return (one - other).norm() < 1e-12; };
  EXPECT_EQ(plate.cracks[0].name, "slit");
  EXPECT_EQ(plate.cracks[0].born, Born::absent);
  EXPECT_TRUE(near(plate.cracks[0].points[0], {1e-3, 2e-3}));
  EXPECT_TRUE(near(plate.cracks[0].points[1], {3e-3, 4e-3}));
  EXPECT_EQ(plate.cracks[1].born, Born::broken);
  EXPECT_EQ(plate.cracks[1].ends, CrackEnds::open);
  EXPECT_EQ(plate.cracks[2].ends, CrackEnds::cut);
  ASSERT_EQ(plate.cracks[1].points.size(), 3U);
  EXPECT_TRUE(near(plate.cracks[1].points[2], {9e-3, 1e-3}));
  EXPECT_TRUE(near(plate.cracks[2].points.front(), {40e-3, 25e-3}));
  EXPECT_TRUE(near(plate.cracks[2].points.back(), {35e-3, 20e-3}));
}

TEST_F(Members, OfRandomCracks) {
  const std::string calls =
      "p:random_cracks { count = 5, length = {1*mm, 2*mm}, angle = {0.3, 0.6}, seed = 7, from = "
      "{10*mm, 5*mm}, to = {50*mm, 35*mm}, born = 'absent' }";
  expect_all_named(random_cracks_doc, calls);
  const Plate& plate = plate_after(calls);
  const std::vector<Crack> wanted = make({.length = {1e-3, 2e-3},
                                          .angle = {0.3, 0.6},
                                          .area = {{10e-3, 5e-3}, {50e-3, 35e-3}},
                                          .seed = 7,
                                          .count = 5,
                                          .born = Born::absent});
  ASSERT_EQ(plate.cracks.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(plate.cracks[k].born, Born::absent);
    for (const std::size_t end : {0U, 1U})
      EXPECT_NEAR((plate.cracks[k].points[end] - wanted[k].points[end]).norm(), 0.0, 1e-12);
  }
}

// Every form of a region, on a load that has nothing else.
TEST_F(Members, OfRegions) {
  const Plate& plate = plate_after(
      "p:nofail { edge = 'left', depth = 2*mm } p:nofail { edge = 'right', depth = 3*mm }\n"
      "p:nofail { edge = 'bottom', depth = 4*mm } p:nofail { edge = 'top', depth = 5*mm }\n"
      "p:nofail { from = {1*mm, 2*mm}, to = {4*mm, 8*mm} }\n"
      "p:nofail { centre = {50*mm, 20*mm}, radius = 6*mm }");
  ASSERT_EQ(plate.no_fail.size(), 6U);
  expect_box(plate.no_fail[0], {0, 0}, {2e-3, 0.04});
  expect_box(plate.no_fail[1], {0.097, 0}, {0.1, 0.04});
  expect_box(plate.no_fail[2], {0, 0}, {0.1, 4e-3});
  expect_box(plate.no_fail[3], {0, 0.035}, {0.1, 0.04});
  expect_box(plate.no_fail[4], {1e-3, 2e-3}, {4e-3, 8e-3});
  expect_box(plate.no_fail[5], {0.044, 0.014}, {0.056, 0.026});
}

TEST_F(Members, OfTractionsAndPressures) {
  const std::string tractions =
      "p:traction { edge = 'right', stress = {1*MPa, 2*MPa}, depth = 3*mm, time = ramp(4*us), name "
      "= 'pull' }\n"
      "p:traction { edge = 'left', stress = function(x, y) return 5*x, 6*y end }\n"
      "p:traction { rim = 'bore', stress = function(x, y, t) return 5*x, 6*t end, angles = {1, 2} "
      "}\n";
  const std::string pressures =
      "p:pressure { rim = 'bore', pressure = 7*MPa, time = pulse(2*us, 3*us), angles = {3, 4}, "
      "name = 'gas' }";
  expect_all_named(plate_traction_doc, tractions);
  expect_all_named(plate_pressure_doc, pressures);
  const Loads& loads = plate_after(tractions + pressures).loads;
  ASSERT_EQ(loads.tractions.size(), 3U);
  EXPECT_EQ(loads.tractions[0].edge, Edge::right);
  EXPECT_EQ(loads.tractions[0].stress.constant(), Vec2(1e6, 2e6));
  EXPECT_EQ(loads.tractions[0].depth, 3e-3);
  EXPECT_DOUBLE_EQ(loads.tractions[0].amplitude.at(1e-6), 0.25);
  EXPECT_EQ(loads.tractions[0].name, "pull");
  EXPECT_EQ(loads.tractions[1].edge, Edge::left);
  EXPECT_EQ(loads.tractions[1].name, "");
  EXPECT_EQ(loads.tractions[1].stress.at({10.0, 100.0}), Vec2(50.0, 600.0));
  EXPECT_EQ(loads.tractions[1].depth, 0.0);
  EXPECT_TRUE(loads.tractions[1].amplitude.is_constant());
  EXPECT_FALSE(loads.tractions[0].angles || loads.tractions[1].stress.varies_in_time());
  EXPECT_FALSE(loads.tractions[2].edge);
  EXPECT_EQ(loads.tractions[2].rim, "bore");
  EXPECT_EQ(loads.tractions[2].angles, Vec2(1.0, 2.0));
  EXPECT_TRUE(loads.tractions[2].stress.varies_in_time());
  EXPECT_EQ(loads.tractions[2].stress.at({10.0, 100.0}, 3.0), Vec2(50.0, 18.0));
  ASSERT_EQ(loads.pressures.size(), 1U);
  EXPECT_EQ(loads.pressures[0].angles, Vec2(3.0, 4.0));
  EXPECT_EQ(loads.pressures[0].rim, "bore");
  EXPECT_EQ(loads.pressures[0].name, "gas");
  EXPECT_EQ(loads.pressures[0].pressure, 7e6);
  EXPECT_EQ(loads.pressures[0].amplitude.at(2.9e-6), 0.0);
  EXPECT_EQ(loads.pressures[0].amplitude.at(4.9e-6), 1.0);
  EXPECT_EQ(loads.pressures[0].amplitude.at(5.1e-6), 0.0);
}

TEST_F(Members, OfBodyForcesAndTemperatures) {
  const Loads& loads =
      plate_after(
          "p:body_force { force = {1, 2}, from = {1*mm, 2*mm}, to = {3*mm, 9*mm}, time = "
          "step_at(3*us) }\n"
          "p:body_force { force = {4, 5} }\n"
          "p:temperature { change = -6, centre = {50*mm, 20*mm}, radius = 5*mm, time = ramp(2*us) "
          "}\n"
          "p:temperature { change = function(x, y) return 7*x + 8*y end }")
          .loads;
  ASSERT_EQ(loads.body_forces.size(), 2U);
  EXPECT_EQ(loads.body_forces[0].force.constant(), Vec2(1, 2));
  expect_box(loads.body_forces[0].region, {1e-3, 2e-3}, {3e-3, 9e-3});
  EXPECT_EQ(loads.body_forces[0].amplitude.at(2.9e-6), 0.0);
  EXPECT_EQ(loads.body_forces[0].amplitude.at(3.1e-6), 1.0);
  EXPECT_EQ(loads.body_forces[1].force.constant(), Vec2(4, 5));
  EXPECT_FALSE(loads.body_forces[1].region);
  ASSERT_EQ(loads.thermal_loads.size(), 2U);
  EXPECT_EQ(loads.thermal_loads[0].change.constant(), -6.0);
  expect_box(loads.thermal_loads[0].region, {0.045, 0.015}, {0.055, 0.025});
  EXPECT_DOUBLE_EQ(loads.thermal_loads[0].amplitude.at(1e-6), 0.5);
  EXPECT_EQ(loads.thermal_loads[1].change.at({10.0, 100.0}), 870.0);
  EXPECT_FALSE(loads.thermal_loads[1].region);
}

TEST_F(Members, OfFoundations) {
  const std::string beds =
      "p:foundation { stiffness = 1e13, along = 'y', edge = 'left', depth = 1*mm, name = 'bed' }\n"
      "p:foundation { stiffness = 2e13, from = {1*mm, 1*mm}, to = {2*mm, 3*mm} }\n"
      "p:foundation { stiffness = 3e13, along = 'x', centre = {50*mm, 20*mm}, radius = 2*mm }\n"
      "p:foundation { stiffness = 4e13, along = 'both' }\n";
  expect_all_named(plate_load_doc<Foundation>, beds);
  const std::vector<Foundation>& found = plate_after(beds).loads.foundations;
  ASSERT_EQ(found.size(), 4U);
  using Along = Foundation::Along;
  const Along along[] = {Along::y, Along::both, Along::x, Along::both};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(found[k].stiffness, 1e13 * (1.0 + static_cast<double>(k)));
    EXPECT_EQ(found[k].along, along[k]) << k;
  }
  EXPECT_EQ(found[0].name, "bed");
  expect_box(found[0].region, {0, 0}, {1e-3, 0.04});
  expect_box(found[1].region, {1e-3, 1e-3}, {2e-3, 3e-3});
  expect_box(found[2].region, {0.048, 0.018}, {0.052, 0.022});
  EXPECT_FALSE(found[3].region);
}

TEST_F(Members, OfAbsorbingEdges) {
  const std::string edges = "p:absorb { edge = 'left' } p:absorb { edge = 'top' } p:absorb {}";
  expect_all_named(plate_load_doc<Absorber>, edges);
  const std::vector<Absorber>& found = plate_after(edges).loads.absorbers;
  using Where = Absorber::Where;
  const Where wanted[] = {Where::left, Where::top, Where::all};
  ASSERT_EQ(found.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(found[k].edge, wanted[k]) << k;
}

TEST_F(Members, OfRollersAndPlatens) {
  const std::string rollers =
      "p:roller { centre = {50*mm, 46*mm}, radius = 5*mm, velocity = {1, -2}, name = 'pin', "
      "friction = 0.3, time "
      "= ramp(4*us) } p:roller { centre = {5*mm, -3*mm}, radius = 3*mm }\n";
  const std::string platens =
      "p:platen { from = {0, 41*mm}, to = {100*mm, 50*mm}, displacement = {0, -1e-5}, name = "
      "'anvil', friction = "
      "0.2, time = ramp(4*us) } p:platen { from = {0, -9*mm}, to = {100*mm, 0}, velocity = {0, 1} "
      "} p:platen { from = {0, -9*mm}, to = {100*mm, 0}, force = {0, 2e5}, mass = 3 }\n";
  expect_all_named(plate_load_doc<Roller>, rollers +
                                               "p:roller { centre = {5*mm, -3*mm}, radius = "
                                               "3*mm, displacement = {0, 1e-5} } p:roller { centre "
                                               "= {5*mm, -3*mm}, force = {0, 1}, mass = 2 }");
  expect_all_named(plate_load_doc<Platen>, platens);
  const Loads& loads = plate_after(rollers + platens).loads;
  ASSERT_EQ(loads.rollers.size(), 2U);
  ASSERT_EQ(loads.platens.size(), 3U);
  const Roller& roller = loads.rollers[0];
  EXPECT_NEAR((roller.centre - Vec2(50e-3, 46e-3)).norm(), 0.0, 1e-15);
  EXPECT_EQ(roller.radius, 5e-3);
  EXPECT_EQ(roller.guided.guide, Guide::velocity);
  EXPECT_EQ(roller.guided.value, Vec2(1, -2));
  EXPECT_EQ(roller.guided.friction, 0.3);
  EXPECT_EQ(roller.guided.name, "pin");
  EXPECT_EQ(roller.guided.amplitude.at(1e-6), 0.25);
  EXPECT_EQ(loads.rollers[1].guided.guide, Guide::displacement);
  EXPECT_EQ(loads.rollers[1].guided.value, Vec2(0, 0));
  const Platen& platen = loads.platens[0];
  EXPECT_NEAR((platen.from - Vec2(0, 41e-3)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((platen.to - Vec2(100e-3, 50e-3)).norm(), 0.0, 1e-15);
  EXPECT_EQ(platen.guided.guide, Guide::displacement);
  EXPECT_EQ(platen.guided.name, "anvil");
  EXPECT_EQ(platen.guided.value, Vec2(0, -1e-5));
  EXPECT_EQ(platen.guided.friction, 0.2);
  EXPECT_EQ(platen.guided.amplitude.at(1e-6), 0.25);
  EXPECT_EQ(loads.platens[1].guided.guide, Guide::velocity);
  EXPECT_EQ(loads.platens[1].guided.mass, 0.0);
  EXPECT_EQ(loads.platens[2].guided.guide, Guide::force);
  EXPECT_EQ(loads.platens[2].guided.value, Vec2(0, 2e5));
  EXPECT_EQ(loads.platens[2].guided.mass, 3.0);
}

TEST_F(Members, OfRollersMustAgree) {
  const auto refusal = [](const std::string& members) {
    return test::message_of(
        "local p = plate { width = 10*mm, height = 10*mm, material = 'duran50' }\n"
        "p:roller { centre = {5*mm, 15*mm}, radius = 4*mm, " +
        members + " }");
  };
  using testing::HasSubstr;
  EXPECT_THAT(refusal("force = {0, -1}, velocity = {0, -1}"),
              HasSubstr("roller: more than one of"));
  EXPECT_THAT(refusal("velocity = {0, -1}, mass = 2"),
              HasSubstr("roller: a mass goes with a force"));
  EXPECT_THAT(refusal("force = {0, 0}"), HasSubstr("roller: its force is 0"));
  EXPECT_THAT(refusal("force = {0, -1}, mass = -2"), HasSubstr("roller: mass is -2"));
  EXPECT_EQ(refusal("force = {0, -1}, mass = 2"), "");
}

TEST_F(Members, OfSupports) {
  const std::string moves =
      "p:move { velocity = {1, 2}, edge = 'left', depth = 1*mm, axis = 'x', time = ramp(4*us), "
      "name = 'grip' }\n"
      "p:move { displacement = {3e-6, 4e-6}, from = {1*mm, 1*mm}, to = {2*mm, 3*mm}, axis = 'y' }\n"
      "p:move { velocity = {5, 6}, centre = {50*mm, 20*mm}, radius = 2*mm }\n";
  expect_all_named(plate_move_doc, moves);
  const Loads& loads =
      plate_after(moves +
                  "p:clamp { edge = 'right', depth = 2*mm, axis = 'x', name = 'wall' }\n"
                  "p:clamp { edge = 'top', depth = 3*mm, axis = 'y' }\n"
                  "p:clamp { edge = 'bottom', depth = 4*mm }")
          .loads;
  ASSERT_EQ(loads.supports.size(), 6U);
  const bool along_x[] = {true, false, true, true, false, true};
  const bool along_y[] = {false, true, true, false, true, true};
  const Vec2 values[] = {{1, 2}, {3e-6, 4e-6}, {5, 6}, {0, 0}, {0, 0}, {0, 0}};
  for (std::size_t k = 0; k < 6; ++k) {
    const Support& support = loads.supports[k];
    EXPECT_EQ(support.along_x, along_x[k]) << k;
    EXPECT_EQ(support.along_y, along_y[k]) << k;
    EXPECT_EQ(support.value.constant(), values[k]) << k;
    EXPECT_EQ(support.kind, k == 1 ? Support::Kind::displacement : Support::Kind::velocity) << k;
    EXPECT_EQ(support.amplitude.is_constant(), k != 0) << k;
  }
  EXPECT_DOUBLE_EQ(loads.supports[0].amplitude.at(1e-6), 0.25);
  EXPECT_EQ(loads.supports[0].name, "grip");
  EXPECT_EQ(loads.supports[3].name, "wall");
  expect_box(loads.supports[0].region, {0, 0}, {1e-3, 0.04});
  expect_box(loads.supports[1].region, {1e-3, 1e-3}, {2e-3, 3e-3});
  expect_box(loads.supports[2].region, {0.048, 0.018}, {0.052, 0.022});
  expect_box(loads.supports[4].region, {0, 0.037}, {0.1, 0.04});
}

TEST_F(Members, OfImpactorsDampingAndStarts) {
  const std::string impactors =
      "p:impactor { centre = {-6*mm, 20*mm}, radius = 5*mm, velocity = {50, -3}, mass = 9, "
      "friction = 0.2, restitution = 0.7, name = 'ball' }\n"
      "p:impactor { centre = {120*mm, 21*mm}, radius = 4*mm, velocity = {-7, 1}, density = 1000 }\n"
      "p:impactor { centre = {50*mm, 60*mm}, radius = 2*mm, velocity = {0, -1} }\n";
  expect_all_named(plate_impactor_doc, impactors);
  const Plate& plate = plate_after(
      impactors +
      "p:damping { rate = 12345, stiffness = 2e-9 }\n"
      "p:initial { velocity = {1, 2}, displacement = {3e-6, 4e-6}, from = {1*mm, 1*mm}, to = "
      "{2*mm, 3*mm} }\n"
      "p:initial { velocity = function(x, y) return 10*x, 20*y end }");
  ASSERT_EQ(plate.loads.impactors.size(), 3U);
  const Impactor& one = plate.loads.impactors[0];
  EXPECT_NEAR((one.centre - Vec2(-6e-3, 20e-3)).norm(), 0.0, 1e-15);
  EXPECT_EQ(one.radius, 5e-3);
  EXPECT_EQ(one.velocity, Vec2(50, -3));
  EXPECT_EQ(one.mass, 9.0);
  EXPECT_EQ(one.friction, 0.2);
  EXPECT_EQ(one.restitution, 0.7);
  EXPECT_EQ(one.name, "ball");
  EXPECT_NEAR(plate.loads.impactors[1].mass, pi * 16e-6 * 1000.0, 1e-12);
  EXPECT_NEAR(plate.loads.impactors[2].mass, pi * 4e-6 * 7850.0, 1e-12);
  EXPECT_EQ(plate.loads.damping, 12345.0);
  EXPECT_EQ(plate.loads.stiffness_damping, 2e-9);
  ASSERT_EQ(plate.initial_conditions.size(), 2U);
  EXPECT_EQ(plate.initial_conditions[0].velocity.constant(), Vec2(1, 2));
  EXPECT_EQ(plate.initial_conditions[0].displacement.constant(), Vec2(3e-6, 4e-6));
  expect_box(plate.initial_conditions[0].region, {1e-3, 1e-3}, {2e-3, 3e-3});
  EXPECT_EQ(plate.initial_conditions[1].velocity.at({1.0, 2.0}), Vec2(10, 40));
  EXPECT_EQ(plate.initial_conditions[1].displacement.at({1.0, 2.0}), Vec2(0, 0));
  EXPECT_FALSE(plate.initial_conditions[1].region);
}

TEST_F(Members, OfStrengthAndContact) {
  const Plate& plate = plate_after(
      "p:strength { modulus = 11, correlation = 2*mm, seed = 7 } p:contact { stiffness = 12, reach "
      "= 0.8, friction = 0.3, restitution = 0.6 }");
  ASSERT_TRUE(plate.scatter && plate.contact);
  EXPECT_EQ(plate.scatter->kind, Scatter::Kind::weibull);
  EXPECT_EQ(plate.scatter->spread, 11.0);
  EXPECT_EQ(plate.scatter->correlation, 2e-3);
  EXPECT_EQ(plate.scatter->seed, 7);
  EXPECT_EQ(plate.contact->stiffness, 12.0);
  EXPECT_EQ(plate.contact->reach, 0.8);
  EXPECT_EQ(plate.contact->friction, 0.3);
  EXPECT_EQ(plate.contact->restitution, 0.6);
  const Plate& other =
      plate_after("p:strength { distribution = 'normal', deviation = 0.1 } p:contact {}");
  EXPECT_EQ(other.scatter->kind, Scatter::Kind::normal);
  EXPECT_EQ(other.scatter->spread, 0.1);
  EXPECT_EQ(other.scatter->seed, 1);
  EXPECT_EQ(other.contact->stiffness, 15.0);
  EXPECT_EQ(other.contact->reach, 0.9);
  EXPECT_EQ(other.contact->friction, 0.0);
  EXPECT_EQ(other.contact->restitution, 1.0);
}

TEST_F(Members, OfNumerics) {
  const std::string calls =
      "s = simulate(p, { spacing = 1*mm, horizon = 3*mm, precision = 'f32', breaking = "
      "'next_step', "
      "quadrature = 'ramp', micromodulus = 'conical', constants = 'continuum', surface = 'volume', "
      "step = 50*ns, "
      "fidelity = 0.2, fused = false, safety = 0.8, force_step = true })";
  // An error budget chooses numerics, and is none of them.
  expect_all_named(simulate_doc, calls + std::string(" within = verify ="));
  plate_after(calls);
  lua_getglobal(L, "s");
  const Numerics numerics = object_at<ScriptedRun>(L, -1)->simulation().numerics();
  EXPECT_EQ(numerics.spacing, 1e-3);
  EXPECT_EQ(numerics.horizon, 3e-3);
  EXPECT_EQ(numerics.precision, Precision::f32);
  EXPECT_EQ(numerics.breaking, Breaking::next_step);
  EXPECT_EQ(numerics.quadrature, Quadrature::ramp);
  EXPECT_EQ(numerics.micromodulus, Micromodulus::conical);
  EXPECT_EQ(numerics.constants, Constants::continuum);
  EXPECT_EQ(numerics.surface, Surface::volume);
  EXPECT_NEAR(numerics.step.value(), 50e-9, 1e-20);
  EXPECT_EQ(numerics.fidelity, 0.2);
  EXPECT_FALSE(numerics.fused);
  EXPECT_EQ(numerics.safety, 0.8);
  EXPECT_TRUE(numerics.force_step);
  run("s = simulate(p, { spacing = 2*mm })");
  lua_getglobal(L, "s");
  const Numerics plain = object_at<ScriptedRun>(L, -1)->simulation().numerics();
  EXPECT_EQ(plain.horizon_or_default(), 8e-3);
  EXPECT_FALSE(plain.step);
  EXPECT_FALSE(plain.force_step);
}

TEST_F(Members, OfMoviesAndTheirPictures) {
  const std::string options =
      "{ 'a.mp4', every = 1*us, width = 640, fps = 12, profile = 'paper', crf = 33, hold = 2.5, "
      "fallback = true, field = 'stress_xx', range = {1, 2}, scale = 'log', colours = 'roma', "
      "second = 'speed', second_range = {3, 4}, arrange = 'right', cracks = false, smooth = true, "
      "average = true, thickness = "
      "6*mm, zoom = {7*mm, 8*mm, 9*mm}, follow = 'up', rotate = 0.5, deformed = true, magnify = "
      "11, "
      "bonds = true, theme = 'light', background = 'dark', title = 'T', clock = false, bar = true, "
      "scale_bar = "
      "false, axes = true, dpi = 200, font_size = 9, load_curve = true, energy = false, graph = "
      "false, markers = "
      "{{1*mm, 2*mm, 'm'}} }";
  std::string known =
      options + " px_per_mm = paper = percentile =";  // alternatives to other options
  expect_all_named(movie_doc, known);
  const MovieOptions movie = noun_of<MovieOptions>(arguments(options, movie_doc));
  EXPECT_EQ(movie.fps, 12.0);
  EXPECT_EQ(movie.profile, Profile::paper);
  EXPECT_EQ(movie.crf, 33);
  EXPECT_EQ(movie.hold, 2.5);
  EXPECT_TRUE(movie.fallback);
  const PictureOptions& picture = movie.picture;
  EXPECT_EQ(picture.width, 640);
  EXPECT_FALSE(picture.pixels_a_mm);
  EXPECT_EQ(picture.field, "stress_xx");
  EXPECT_EQ(picture.range->min, 1.0);
  EXPECT_EQ(picture.range->max, 2.0);
  EXPECT_FALSE(picture.percentile);
  EXPECT_EQ(picture.scale, Scale::log);
  EXPECT_EQ(picture.colours, "roma");
  EXPECT_EQ(picture.second, "speed");
  EXPECT_EQ(picture.second_range->min, 3.0);
  EXPECT_EQ(picture.second_range->max, 4.0);
  EXPECT_EQ(picture.arrangement, Arrangement::right);
  EXPECT_FALSE(picture.cracks);
  EXPECT_TRUE(picture.smooth);
  EXPECT_TRUE(picture.average);
  EXPECT_EQ(picture.thickness, 6e-3);
  EXPECT_NEAR((picture.zoom->centre - Vec2(7e-3, 8e-3)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(picture.zoom->half_width, 9e-3, 1e-15);
  EXPECT_EQ(picture.follow, Toward::up);
  EXPECT_EQ(picture.rotation, 0.5);
  EXPECT_TRUE(picture.deformed);
  EXPECT_EQ(picture.magnification, 11.0);
  EXPECT_TRUE(picture.bonds);
  EXPECT_EQ(picture.look, Look::light);
  EXPECT_EQ(picture.background, Background::dark);
  EXPECT_EQ(picture.overlay.title, "T");
  EXPECT_FALSE(picture.overlay.clock);
  EXPECT_TRUE(picture.overlay.bar);
  EXPECT_FALSE(picture.overlay.scale_bar);
  EXPECT_TRUE(picture.overlay.axes);
  EXPECT_EQ(picture.dpi, 200.0);
  EXPECT_EQ(picture.font_size, 9.0);
  EXPECT_TRUE(picture.overlay.load_curve);
  EXPECT_FALSE(picture.overlay.energy);
  ASSERT_EQ(picture.overlay.markers.size(), 1U);
  EXPECT_EQ(picture.overlay.markers[0].place, Vec2(1e-3, 2e-3));
  EXPECT_EQ(picture.overlay.markers[0].label, "m");
}

// Flags one at a time, and options that are alternatives to others.
TEST_F(Members, OfPicturesOneByOne) {
  const auto picture = [this](const std::string& option) {
    return noun_of<PictureOptions>(arguments("{ 'a.png', " + option + " }", frame_doc));
  };
  EXPECT_EQ(picture("px_per_mm = 7").pixels_a_mm, 7.0);
  EXPECT_EQ(picture("paper = 85*mm").paper, 0.085);
  EXPECT_EQ(picture("percentile = 98").percentile, 98.0);
  EXPECT_EQ(picture("scale = 'linear'").scale, Scale::linear);
  EXPECT_EQ(picture("follow = 'none'").follow, std::nullopt);
  EXPECT_EQ(picture("second = 'none'").second, std::nullopt);
  const std::pair<const char*, bool OverlayOptions::*> flags[] = {
      {"clock", &OverlayOptions::clock},         {"bar", &OverlayOptions::bar},
      {"scale_bar", &OverlayOptions::scale_bar}, {"axes", &OverlayOptions::axes},
      {"energy", &OverlayOptions::energy},       {"load_curve", &OverlayOptions::load_curve},
      {"graph", &OverlayOptions::graph}};
  const OverlayOptions usual;
  for (const auto& [name, flag] : flags)
    for (const bool value : {false, true}) {
      const OverlayOptions found =
          picture(std::string(name) + (value ? " = true" : " = false")).overlay;
      for (const auto& [other, member] : flags)
        EXPECT_EQ(found.*member, member == flag ? value : usual.*member) << name << ' ' << other;
    }
  const std::pair<const char*, bool PictureOptions::*> more[] = {
      {"cracks", &PictureOptions::cracks},
      {"smooth", &PictureOptions::smooth},
      {"average", &PictureOptions::average},
      {"deformed", &PictureOptions::deformed},
      {"bonds", &PictureOptions::bonds}};
  const PictureOptions plain;
  for (const auto& [name, flag] : more)
    for (const bool value : {false, true}) {
      const PictureOptions found = picture(std::string(name) + (value ? " = true" : " = false"));
      for (const auto& [other, member] : more)
        EXPECT_EQ(found.*member, member == flag ? value : plain.*member) << name << ' ' << other;
    }
}

// A simulation takes the same loads as a plate; only the same kind at the same place is replaced.
TEST_F(Members, OfLoadsOfASimulation) {
  plate_after(
      "p:traction { edge = 'top', stress = {0, 1*MPa} }\n"
      "p:traction { edge = 'left', stress = {2*MPa, 0} }\n"
      "p:clamp { edge = 'left', depth = 4*mm, axis = 'x' }\n"
      "s = simulate(p, { spacing = 2*mm })\n"
      "s:traction { edge = 'top', stress = {3, 4}, depth = 5*mm, time = ramp(4*us) }\n"
      "s:pressure { rim = 'bore', pressure = 6 } s:body_force { force = {7, 8} }\n"
      "s:clamp { edge = 'left', depth = 4*mm, axis = 'y' }\n"
      "s:move { velocity = {9, 10}, edge = 'right', depth = 4*mm }\n"
      "s:temperature { change = 11 } s:damping { rate = 12 }\n"
      "s:impactor { centre = {120*mm, 20*mm}, radius = 4*mm, velocity = {-7, 1}, mass = 13 }");
  lua_getglobal(L, "s");
  const Loads& loads = object_at<ScriptedRun>(L, -1)->simulation().plate().loads;
  ASSERT_EQ(loads.tractions.size(), 2U);
  EXPECT_EQ(loads.tractions[0].edge, Edge::left);
  EXPECT_EQ(loads.tractions[0].stress.constant(), Vec2(2e6, 0));
  EXPECT_EQ(loads.tractions[1].edge, Edge::top);
  EXPECT_EQ(loads.tractions[1].stress.constant(), Vec2(3, 4));
  EXPECT_EQ(loads.tractions[1].depth, 5e-3);
  EXPECT_EQ(loads.tractions[1].amplitude.at(1e-6), 0.25);
  EXPECT_EQ(loads.pressures.at(0).pressure, 6.0);
  EXPECT_EQ(loads.body_forces.at(0).force.constant(), Vec2(7, 8));
  ASSERT_EQ(loads.supports.size(), 3U);
  EXPECT_TRUE(loads.supports[0].along_x && !loads.supports[0].along_y);
  EXPECT_TRUE(!loads.supports[1].along_x && loads.supports[1].along_y);
  EXPECT_EQ(loads.supports[2].value.constant(), Vec2(9, 10));
  EXPECT_EQ(loads.thermal_loads.at(0).change.constant(), 11.0);
  EXPECT_EQ(loads.damping, 12.0);
  EXPECT_EQ(loads.impactors.at(0).mass, 13.0);
}

// Compares the fields of a simulation with its C++ values; all entries of the ledger differ.
TEST_F(Members, OfWhatASimulationTells) {
  plate_after(
      "p:traction { edge = 'top', stress = {0, 30*MPa}, time = ramp(1*us) }\n"
      "p:crack { from = {0, 20*mm}, to = {40*mm, 20*mm} } p:contact {} p:damping { rate = 1e4 }\n"
      "s = simulate(p, { spacing = 1*mm, horizon = 3*mm }) s:run(20*us) e = s.energy d = s.damage");
  const auto number = [this](const std::string& expression) {
    EXPECT_EQ(luaL_loadstring(L, ("return " + expression).c_str()), LUA_OK);
    protected_call(L, 0, 1);
    const double value = lua_tonumber(L, -1);
    lua_pop(L, 1);
    return value;
  };
  lua_getglobal(L, "s");
  const Simulation& simulation = object_at<ScriptedRun>(L, -1)->simulation();
  const Energy ledger = energy(simulation);
  const std::set<double> entries{ledger.kinetic, ledger.strain,  ledger.broken,
                                 ledger.damped,  ledger.contact, ledger.external};
  EXPECT_EQ(entries.size(), 6U);
  EXPECT_EQ(number("e.kinetic"), ledger.kinetic);
  EXPECT_EQ(number("e.strain"), ledger.strain);
  EXPECT_EQ(number("e.broken"), ledger.broken);
  EXPECT_EQ(number("e.damped"), ledger.damped);
  EXPECT_EQ(number("e.released"), ledger.released);
  EXPECT_EQ(number("e.contact"), ledger.contact);
  EXPECT_EQ(number("e.external"), ledger.external);
  EXPECT_EQ(number("e.residual"), ledger.residual());
  EXPECT_EQ(number("d.broken_bonds"), double(count_damage(simulation).broken_bonds));
  EXPECT_EQ(number("d.most"), count_damage(simulation).max);
  EXPECT_GT(number("d.broken_bonds"), 0.0);
  EXPECT_EQ(number("s.time"), simulation.time());
  EXPECT_EQ(number("s.steps"), double(simulation.state().step));
  EXPECT_EQ(number("s.dt"), simulation.dt());
  EXPECT_EQ(number("s.dt_limit"), simulation.lattice().step_limit);
  EXPECT_EQ(number("s.nodes"), 4000.0);
  EXPECT_EQ(number("s.bonds"), double(simulation.lattice().initial_bonds()));
  EXPECT_EQ(number("p.width"), 0.1);
  EXPECT_EQ(number("p.height"), 0.04);
  const Vec2 u = simulation.displacement(70, 35);
  EXPECT_EQ(number("s:at({70.5*mm, 35.5*mm}).ux"), u.x());
  EXPECT_EQ(number("s:at({70.5*mm, 35.5*mm}).uy"), u.y());
  EXPECT_NEAR(number("s:at({70.4*mm, 35.4*mm}).x"), 70.5e-3, 1e-12);
  EXPECT_NEAR(number("s:at({70.4*mm, 35.4*mm}).y"), 35.5e-3, 1e-12);
  EXPECT_EQ(number("s:at({30*mm, 20.5*mm}).damage"), damage_of(simulation, 30, 20));
  EXPECT_GT(damage_of(simulation, 30, 20), 0.0);
}

}  // namespace
}  // namespace hackle
