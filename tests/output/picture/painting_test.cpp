// SPDX-License-Identifier: MIT
#include "output/picture/painting.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "output/picture/field_choice.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// The grid of the edge-cracked plate at 0.5 mm.
const Grid grid{200, 80, 0.5e-3, {0.05, 0.02}};

PictureOptions zoomed(double x, double y, double half_width) {
  PictureOptions options;
  options.zoom = Zoom{{x, y}, half_width};
  return options;
}

TEST(Painting, RefusesAZoomThatShowsNothing) {
  const double nan = std::nan(""), infinite = HUGE_VAL;
  for (const auto& [x, y, half] : {std::tuple{0.2, 0.02, 0.01},
                                   {0.05, -0.1, 0.01},
                                   {nan, 0.02, 0.01},
                                   {0.05, infinite, 0.01},
                                   {0.05, 0.02, 0.0},
                                   {0.05, 0.02, -0.01},
                                   {0.05, 0.02, 1.01},
                                   {0.05, 0.02, 1e-4},
                                   {0.05, 0.02, nan},
                                   {0.05, 0.02, infinite}})
    EXPECT_THROW(check("frame", zoomed(x, y, half), grid), Error) << x << " " << y << " " << half;
}

TEST(Painting, SaysWhereThePlateIs) {
  try {
    check("frame", zoomed(0.2, 0.02, 0.01), grid);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(),
                HasSubstr("frame: zoom shows nothing of the plate, its middle is {200 mm, 20 mm}"));
    EXPECT_THAT(error.what(), HasSubstr("from {0 m, 0 m} to {100 mm, 40 mm}"));
  }
}

TEST(Painting, ABarePictureHasThePixelsThatWereAskedFor) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  for (const Extent& size : {Extent{320, 64}, {1, 1}, {7, 301}}) {
    const Image image = paint(simulation, {}, size);
    EXPECT_EQ(image.width, size.width);
    EXPECT_EQ(image.height, size.height);
  }
}

TEST(Painting, TheOverlayIsAsTheOptionsHaveIt) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  PictureOptions options;
  EXPECT_EQ(style_of(options, simulation).title, simulation.plate().material.name);
  const Image plain = paint(simulation, options);
  options.overlay.title = "";
  options.overlay.clock = options.overlay.bar = options.overlay.scale_bar = false;
  EXPECT_EQ(style_of(options, simulation).title, "");
  EXPECT_LT(paint(simulation, options).height, plain.height);
  options.overlay.load_curve = true;
  options.overlay.bar = true;
  EXPECT_GT(paint(simulation, options).height, plain.height);
}

// A light theme changes ground and map; either can be chosen by itself.
TEST(Painting, AThemeIsGroundAndColours) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  PictureOptions options;
  options.look = Look::light;
  EXPECT_EQ(style_of(options, simulation).background, Background::light);
  EXPECT_EQ(style_of(options, simulation).field.colour_map, "ember");
  options.second = "von_mises";
  EXPECT_EQ(style_of(options, simulation).second->colour_map, "lagoon");
  options.colours = "viridis";
  options.background = Background::transparent;
  EXPECT_EQ(style_of(options, simulation).field.colour_map, "viridis");
  EXPECT_EQ(style_of(options, simulation).background, Background::transparent);
}

TEST(Painting, OnlyFieldsWithoutALimitWiden) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  PictureOptions options;
  const auto widens = [&](const char* field) {
    options.field = field;
    return style_of(options, simulation).field.widens;
  };
  for (const char* field : {"damage", "stretch", "fragments", "strength"})
    EXPECT_FALSE(widens(field)) << field;
  for (const char* field : {"speed", "stress_xx", "fringes", "displacement"})
    EXPECT_TRUE(widens(field)) << field;
  options.range = Ends{0.0, 1.0};
  EXPECT_FALSE(widens("speed"));
}

// The plate flies at 30 m/s, far beyond the speeds at which glass breaks.
TEST(Painting, ARangeFitsWhatIsSeen) {
  Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  State state = simulation.state();
  const double unit = simulation.dt() / simulation.lattice().grid.dx;
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 100; ++i) state.set_v(i, j, {30.0 * unit, 0.0});
  simulation.restore(std::move(state));
  PictureOptions options;
  options.field = "speed";
  const Ends usual = usual_ends(options, simulation);
  ASSERT_LT(usual.max, 30.0);
  const Ends fitting = fitting_range(first_field(options), simulation, usual);
  EXPECT_EQ(fitting.min, usual.min);
  EXPECT_GE(fitting.max, 30.0);
  EXPECT_LT(fitting.max, 2.5 * 30.0);
  const Image shown = paint(simulation, options);
  options.range = fitting;
  const Image same = paint(simulation, options);
  ASSERT_EQ(shown.pixels.size(), same.pixels.size());
  const Rectangle plate = layout_of(style_of(options, simulation)).plate;
  int differing = 0;
  for (int y = plate.y; y < plate.bottom(); ++y)
    differing += std::equal(&shown.pixels[static_cast<std::size_t>(y * shown.stride())],
                            &shown.pixels[static_cast<std::size_t>((y + 1) * shown.stride())],
                            &same.pixels[static_cast<std::size_t>(y * same.stride())])
                     ? 0
                     : 1;
  EXPECT_EQ(differing, 0);
  EXPECT_NE(shown.pixels, same.pixels) << "the picture says that it was widened";
}

TEST(Painting, AnAbsentCrackIsAGapInEveryFieldButDamage) {
  Plate plate = test::edge_crack(12e6);
  plate.cracks[0].born = Born::absent;
  const Simulation simulation(plate, test::numerics(1e-3, 4e-3), {1});
  const Simulation broken(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  PictureOptions options;
  EXPECT_TRUE(shot_of(options, simulation).gaps.empty());
  for (const char* field : {"stress_yy", "strength"}) {
    options.field = field;
    EXPECT_EQ(shot_of(options, simulation).gaps, shot_of(options, broken).gaps) << field;
  }
  const Image image = paint(simulation, options);
  const Rectangle seen = layout_of(style_of(options, simulation)).plate;
  const auto* pixel = &image.pixels[static_cast<std::size_t>(
      (seen.y + seen.height / 2) * image.stride() + 4 * (seen.x + seen.width / 4))];
  EXPECT_EQ(pixel[2], background_colour.red);
}

std::string refusal_of(const PictureOptions& options) {
  try {
    check("frame", options, grid);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
}

// 85 mm at 300 px an inch are 1004 px, 8 pt are 33.
TEST(Painting, PaperHasItsOwnSizes) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  PictureOptions options;
  EXPECT_EQ(style_of(options, simulation).font, 0.0);
  options.paper = 85e-3;
  EXPECT_EQ(style_of(options, simulation).width, 1004);
  EXPECT_EQ(style_of(options, simulation).font, 33.0);
  EXPECT_EQ(layout_of(style_of(options, simulation)).font, 33.0);
  options.dpi = 600.0;
  options.font_size = 6.0;
  EXPECT_EQ(style_of(options, simulation).width, 2008);
  EXPECT_EQ(style_of(options, simulation).dpi, 600.0);
  EXPECT_EQ(style_of(options, simulation).font, 50.0);
  EXPECT_EQ(refusal_of(options), "");
}

TEST(Painting, PaperThatDoesNotFitIsRefused) {
  PictureOptions options;
  options.paper = 0.5;
  options.dpi = 600.0;
  EXPECT_THAT(refusal_of(options), HasSubstr("500 mm of paper at 600 dpi are 11812 px"));
  options = {};
  options.font_size = 40.0;
  EXPECT_THAT(refusal_of(options), HasSubstr("a font_size of 40 pt is 167 px of a width of 1280"));
  options = {};
  options.paper = 85e-3;
  options.pixels_a_mm = 4.0;
  EXPECT_THAT(refusal_of(options), HasSubstr("paper and px_per_mm are given"));
  options = {};
  options.overlay.axes = true;
  options.rotation = 0.1;
  EXPECT_THAT(refusal_of(options), HasSubstr("axes cannot be turned"));
}

TEST(Painting, ChartsArePaidForOnlyWhereAskedFor) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  PictureOptions options;
  EXPECT_TRUE(shot_of(options, simulation).energy.curves.empty());
  EXPECT_TRUE(shot_of(options, simulation).load_curve.curves.empty());
  options.overlay.energy = options.overlay.load_curve = true;
  EXPECT_EQ(shot_of(options, simulation).energy.curves.size(), 3U);
  EXPECT_EQ(shot_of(options, simulation).load_curve.curves.size(), 2U);
}

TEST(Painting, TheWidestPictureFits) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics(), {1});
  EXPECT_EQ(widest_picture({}, simulation, {1281, 2000}), 1280);
  EXPECT_EQ(widest_picture({}, simulation, {300, 2000}), 0);
  EXPECT_EQ(widest_picture({}, simulation, {2000, 50}), 0);
  const int width = widest_picture({}, simulation, {2000, 400});
  EXPECT_LE(make_layout(grid, width).height, 400);
  EXPECT_GT(make_layout(grid, width + 2).height, 400);
}

TEST(Painting, OnlyAPictureByItselfIsTransparent) {
  PictureOptions options;
  EXPECT_NO_THROW(check_opaque("movie", options));
  options.background = Background::transparent;
  EXPECT_NO_THROW(check("frame", options, grid));
  EXPECT_THROW(check_opaque("movie", options), Error);
}

TEST(Painting, AShotHoldsNoMoreThanItsPictureShows) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  const std::size_t nodes = simulation.lattice().grid.nodes();
  PictureOptions options;
  EXPECT_TRUE(shot_of(options, simulation).gaps.empty());
  EXPECT_TRUE(shot_of(options, simulation).displacement.empty());
  options.field = "stress_1";
  EXPECT_EQ(shot_of(options, simulation).gaps.size(), nodes);
  options.deformed = true;
  EXPECT_EQ(shot_of(options, simulation).displacement.size(), 2 * nodes);
  EXPECT_EQ(shot_of(options, simulation).links.size(), nodes);
}

// All values differ.
TEST(Painting, AStyleHasEveryOptionInItsPlace) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  PictureOptions options;
  options.field = "stress_xx";
  options.range = Ends{1.0, 2.0};
  options.scale = Scale::log;
  options.colours = "roma";
  options.second = "speed";
  options.second_range = Ends{3.0, 4.0};
  options.arrangement = Arrangement::over;
  options.rotation = 0.5;
  options.width = 640;
  options.background = Background::light;
  options.deformed = true;
  options.magnification = 7.0;
  options.overlay.title = "T";
  options.overlay.clock = false;
  options.overlay.markers = {{{0.01, 0.02}, "m"}};
  const PictureStyle style = style_of(options, simulation);
  EXPECT_EQ(style.field.label, "stress xx");
  EXPECT_EQ(style.field.unit, "Pa");
  EXPECT_EQ(style.field.colour_map, "roma");
  EXPECT_EQ(style.field.min, 1.0);
  EXPECT_EQ(style.field.max, 2.0);
  EXPECT_TRUE(style.field.logarithmic);
  EXPECT_EQ(style.field.sampling, Sampling::mean);
  ASSERT_TRUE(style.second);
  EXPECT_EQ(style.second->label, "speed");
  EXPECT_EQ(style.second->unit, "m/s");
  EXPECT_EQ(style.second->colour_map, "inferno");
  EXPECT_EQ(style.second->min, 3.0);
  EXPECT_EQ(style.second->max, 4.0);
  EXPECT_FALSE(style.second->logarithmic);
  EXPECT_EQ(style.arrangement, Arrangement::over);
  EXPECT_EQ(style.rotation, 0.5);
  EXPECT_EQ(style.width, 640);
  EXPECT_EQ(style.background, Background::light);
  EXPECT_EQ(style.magnification, 7.0);
  EXPECT_EQ(style.note, "displacements × 7");
  EXPECT_EQ(style.title, "T");
  EXPECT_FALSE(style.overlay.clock);
  EXPECT_EQ(style.overlay.markers.size(), 1U);
  options.pixels_a_mm = 5.0;  // 5 px per cell of 1 mm
  EXPECT_EQ(style_of(options, simulation).cell, 5.0);
}

TEST(Painting, EndsOfALogarithmAreFourDecadesAndFringesGrowWithTheThickness) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  PictureOptions options;
  options.field = "speed";
  const Ends plain = usual_ends(options, simulation);
  options.scale = Scale::log;
  EXPECT_EQ(usual_ends(options, simulation).max, plain.max);
  EXPECT_EQ(usual_ends(options, simulation).min, 1e-4 * plain.max);
  options = {};
  options.field = "fringes";
  options.thickness = 2e-3;
  const double thin = usual_ends(options, simulation).max;
  options.thickness = 6e-3;
  EXPECT_DOUBLE_EQ(usual_ends(options, simulation).max, 3.0 * thin);
  EXPECT_EQ(style_of(options, simulation).title, "Duran 50 glass, 6 mm thick");
}

// Values as in the fields, nothing outside the material, and gaps in 1/255.
TEST(Painting, AShotHasTheValuesOfItsFields) {
  Plate plate = test::edge_crack(12e6);
  plate.cutouts.push_back({rectangle({70e-3, 10e-3}, {80e-3, 20e-3}), ""});
  Simulation simulation(plate, test::numerics(1e-3, 4e-3), {1});
  simulation.run(4e-6);
  PictureOptions options;
  options.field = "displacement_y";
  options.second = "fringes";
  options.thickness = 8e-3;
  options.deformed = true;
  const Shot shot = shot_of(options, simulation);
  const Lattice& lattice = simulation.lattice();
  const std::vector<float> first = scalar_of("displacement_y").values(simulation);
  const std::vector<float> second = scalar_of("fringes").values(simulation);
  const std::vector<float> phi = damage(simulation).values;
  ASSERT_EQ(shot.second.size(), lattice.grid.nodes());
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 100; ++i) {
      const std::size_t node = lattice.grid.index(i, j);
      const bool nothing = i >= 70 && i < 80 && j >= 10 && j < 20;
      ASSERT_EQ(std::isnan(shot.values[node]), nothing) << i << ' ' << j;
      ASSERT_EQ(std::isnan(shot.second[node]), nothing) << i << ' ' << j;
      EXPECT_EQ(shot.gaps[node], std::lround(255.0F * phi[node]));
      if (nothing) continue;
      EXPECT_EQ(shot.values[node], first[node]);
      EXPECT_EQ(shot.second[node], 8e-3F * second[node]);
    }
  EXPECT_EQ(shot.time, simulation.time());
  EXPECT_EQ(shot.displacement, displacement(simulation).values);
  options.cracks = false;
  EXPECT_TRUE(shot_of(options, simulation).gaps.empty());
}

}  // namespace
}  // namespace hackle
