// SPDX-License-Identifier: MIT
#include "render/overlay/layout.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "render/overlay/overlay.hpp"

namespace hackle {
namespace {

Grid grid(int nx, int ny) {
  return {nx, ny, 1e-3, {0.5e-3 * nx, 0.5e-3 * ny}};
}

// The box of a drawn part, px.
struct Box {
  double left, top, right, bottom;
};

Box box_of(const Rectangle& r) {
  return {static_cast<double>(r.x), static_cast<double>(r.y), static_cast<double>(r.right()),
          static_cast<double>(r.bottom())};
}

// Returns the box of the ink of a text, as measured by Cairo.
Box box_of(const Font& font, const PlacedText& text) {
  cairo_text_extents_t ink;
  cairo_scaled_font_text_extents(font.scaled(text.size).get(), text.text.c_str(), &ink);
  return {text.x + ink.x_bearing, text.y + ink.y_bearing, text.x + ink.x_bearing + ink.width,
          text.y + ink.y_bearing + ink.height};
}

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

void expect_inside(const Box& box, const Layout& layout) {
  EXPECT_GE(box.left, 0.0);
  EXPECT_GE(box.top, 0.0);
  EXPECT_LE(box.right, layout.width);
  EXPECT_LE(box.bottom, layout.height);
}

std::string words(std::mt19937& random, int max) {
  static const std::string_view alphabet[] = {"W", "i", " ", "µ", "×", "g", "0", "ß"};
  std::string text;
  for (int left = std::uniform_int_distribution<int>(0, max)(random); left > 0; --left)
    text += alphabet[std::uniform_int_distribution<std::size_t>(0, 7)(random)];
  return text;
}

OverlayText any_text(std::mt19937& random) {
  const auto maybe = [&] { return std::bernoulli_distribution(0.7)(random); };
  const auto number = [&](double max) {
    return std::uniform_real_distribution<double>(0.0, max)(random);
  };
  OverlayText text;
  text.parts = {{}, maybe(), maybe(), maybe(), maybe(), maybe(), {}};
  const int longest = maybe() ? 20 : 200;
  text.title = words(random, longest);
  text.note = words(random, longest);
  if (maybe()) text.slow_motion = std::pow(10.0, number(9.0));
  if (!maybe()) text.bars.emplace_back();
  for (BarText& bar : text.bars) {
    bar.label = words(random, longest / 2) + "g";
    bar.logarithmic = !maybe();
    bar.min = std::pow(10.0, number(12.0) - 6.0);
    bar.max = bar.min * std::pow(10.0, 0.1 + number(9.0));
    if (!bar.logarithmic && maybe()) bar.min = -bar.max;
  }
  return text;
}

Chart any_chart(std::mt19937& random, double now) {
  Chart chart{words(random, 30), "J/m", 3e-5, {}};
  for (int k = std::uniform_int_distribution<int>(0, 6)(random); k > 0; --k)
    chart.curves.push_back({words(random, 12) + "n",
                            "",
                            {{now, std::uniform_real_distribution<double>(-1e5, 1e5)(random)}}});
  return chart;
}

Camera camera_of(const Grid& seen, const Layout& layout) {
  return {seen, {0, 0, seen.nx, seen.ny}, 0.0, layout.plate};
}

// Draws everything and checks that texts and parts do not overlap.
void expect_sound(const Grid& seen, int width, const OverlayText& text, const PlateSize& size,
                  const Moment& moment) {
  const Layout layout = make_layout(seen, width, text, size);
  EXPECT_EQ(layout.width % 2, 0);
  EXPECT_EQ(layout.height % 2, 0);
  EXPECT_GT(layout.plate.width, 0);
  EXPECT_GT(layout.plate.height, 0);
  const Camera camera = camera_of(seen, layout);
  Overlay overlay(layout, text, std::vector<ColourMap>(text.bars.size(), {"", {{}, {}}}),
                  camera.pixels_a_metre().x());
  Image image(layout.width, layout.height);
  overlay.draw(image, {camera, Camera(seen, {0, 0, seen.nx, seen.ny}, 0.0, layout.second_plate)},
               moment);
  const Font font;
  std::vector<Box> boxes{box_of(layout.plate)};
  if (size.twice) boxes.push_back(box_of(layout.second_plate));
  for (const BarRoom& bar : layout.bars) boxes.push_back(box_of(bar.colours));
  for (const PlacedText& one : overlay.texts())
    if (!one.text.empty()) boxes.push_back(box_of(font, one));
  for (const Rectangle& chart : {layout.load_curve, layout.energy}) {
    EXPECT_FALSE(overlap(box_of(chart), box_of(layout.plate)));
    EXPECT_FALSE(overlap(box_of(chart), box_of(layout.scale)));
    expect_inside(box_of(chart), layout);
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    expect_inside(boxes[k], layout);
    for (std::size_t other = 0; other < k; ++other)
      EXPECT_FALSE(overlap(boxes[k], boxes[other])) << k << " and " << other;
  }
}

TEST(Layout, NothingOverlapsWhateverThePlateTheWidthAndTheTexts) {
  std::mt19937 random(5);
  const auto up_to = [&](int max) { return std::uniform_int_distribution<int>(1, max)(random); };
  for (int trial = 0; trial < 250; ++trial) {
    const bool large = trial % 10 == 0;  // of a flat plate, to save memory
    const int width = 2 * (large ? 960 + up_to(2880) : 159 + up_to(640));
    const int nx = up_to(3000), ny = large ? 1 + nx / 50 : up_to(3000);
    SCOPED_TRACE(testing::Message()
                 << "trial " << trial << ": " << nx << " x " << ny << " at " << width);
    const double now = 1e-7 * up_to(10000000);
    expect_sound(grid(nx, ny), width, any_text(random), {0.0, trial % 4 == 1},
                 {now, {}, any_chart(random, now), any_chart(random, now)});
    if (testing::Test::HasFailure()) return;
  }
}

// Labels lie on the plate, so they are checked separately.
TEST(Layout, LabelsOfMarkersKeepToThemselves) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> share(-0.1, 1.1);
  const Font font;
  for (int trial = 0; trial < 200; ++trial) {
    const int nx = 1 + trial * 7, ny = 1 + (trial * trial) % 900;
    OverlayText text;
    for (int k = 0; k < 12; ++k)
      text.parts.markers.push_back(
          {{1e-3 * nx * share(random), 1e-3 * ny * share(random)}, words(random, 60)});
    const Layout layout = make_layout(grid(nx, ny), 320 + 6 * trial, text);
    std::vector<Box> boxes;
    for (const PlacedMarker& marker : place_markers(text.parts.markers, layout, layout.plate,
                                                    camera_of(grid(nx, ny), layout), font)) {
      EXPECT_TRUE(overlap(box_of(layout.plate), {marker.place.x() - 1, marker.place.y() - 1,
                                                 marker.place.x() + 1, marker.place.y() + 1}));
      if (!marker.label || marker.label->text.empty()) continue;
      const Box box = box_of(font, *marker.label);
      EXPECT_GE(box.top, layout.caption.bottom());
      EXPECT_LE(box.bottom, layout.foot);
      expect_inside(box, layout);
      for (const Box& other : boxes) EXPECT_FALSE(overlap(box, other)) << trial;
      boxes.push_back(box);
    }
  }
}

TEST(Layout, LinesAreAddedWhereTextsDoNotFitBesideEachOther) {
  OverlayText text;
  text.title = "Glass";
  const Layout one = make_layout(grid(200, 80), 640, text);
  text.note = "deformed × 100";
  EXPECT_EQ(make_layout(grid(200, 80), 640, text).height, one.height);
  text.note = std::string(90, 'n');
  const Layout two = make_layout(grid(200, 80), 640, text);
  EXPECT_GT(two.height, one.height);
  EXPECT_GT(two.note.y, two.title.y);
  text.title = std::string(500, 'M');
  const Layout three = make_layout(grid(200, 80), 640, text);
  EXPECT_GT(three.clock.y, three.title.y);
}

TEST(Layout, ALongNameStandsAboveItsBar) {
  OverlayText text;
  EXPECT_LT(make_layout(grid(200, 80), 640, text).bars[0].label.right(),
            make_layout(grid(200, 80), 640, text).bars[0].colours.x);
  text.bars[0].label = "a name of a field that goes on and on and on and on (MPa)";
  const Layout layout = make_layout(grid(200, 80), 640, text);
  EXPECT_LE(layout.bars[0].label.bottom(), layout.bars[0].colours.y);
}

TEST(Layout, WhatIsNotShownTakesNoRoom) {
  OverlayText bare;
  bare.parts.clock = bare.parts.bar = bare.parts.scale_bar = false;
  const Layout layout = make_layout(grid(200, 80), 1280, bare);
  EXPECT_TRUE(layout.caption.empty());
  EXPECT_TRUE(layout.bars.empty());
  EXPECT_TRUE(layout.scale.empty());
  EXPECT_LE(layout.height, layout.plate.height + 2 * layout.plate.x);
}

TEST(Layout, ThePapersPlateHasCellsOfSixPixels) {
  const Layout layout = make_layout(grid(200, 80), 1280);
  EXPECT_EQ(layout.plate.width, 1200);
  EXPECT_EQ(layout.plate.height, 480);
  EXPECT_EQ(layout.plate.x, 40);
  EXPECT_LT(layout.height, 720);
}

TEST(Layout, KeepsTheShapeOfThePlate) {
  for (const int ny : {20, 80, 400}) {
    const Layout layout = make_layout(grid(200, ny), 1280);
    const double shape = static_cast<double>(layout.plate.width) / layout.plate.height;
    EXPECT_NEAR(shape * ny / 200.0, 1.0, 0.02) << ny;
  }
}

TEST(Layout, ABarePictureIsAllPlate) {
  const Layout layout = bare_layout(321, 7);
  EXPECT_EQ(layout.plate.width, 321);
  EXPECT_EQ(layout.plate.height, 7);
  EXPECT_EQ(layout.plate.x, 0);
  EXPECT_EQ(layout.plate.y, 0);
}

TEST(Window, IsALatticeInTheSamePlace) {
  const Grid whole = grid(200, 80);
  const Grid part = hackle::part(whole, {150, -10, 20, 30});
  EXPECT_EQ(part.nx, 20);
  EXPECT_EQ(part.ny, 30);
  EXPECT_LT((part.position(0, 0) - whole.position(150, -10)).norm(), 1e-15);
  EXPECT_LT((part.position(19, 29) - whole.position(169, 19)).norm(), 1e-15);
}

TEST(Neat, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(neat_at_most(0.0171), 0.01);
  EXPECT_DOUBLE_EQ(neat_at_most(2.0), 2.0);
  EXPECT_DOUBLE_EQ(neat_at_most(4.99), 2.0);
  EXPECT_DOUBLE_EQ(neat_at_most(700.0), 500.0);
}

TEST(Layout, CellsHaveTheSizeThatIsGiven) {
  for (const double cell : {0.4, 2.5, 6.0, 7.3})
    for (const bool twice : {false, true})
      for (const Grid& plate : {grid(200, 80), grid(30, 200), grid(1, 1)}) {
        const PlateSize size{cell, twice};
        const int width = width_for(plate, size);
        const Layout layout = make_layout(plate, width, {}, size);
        EXPECT_EQ(width % 2, 0);
        EXPECT_NEAR(layout.plate.width, std::max(1.0, cell * plate.nx), 0.5 + 1e-9);
        EXPECT_GE(layout.plate.x, 0);
        EXPECT_LE(twice ? layout.second_plate.right() : layout.plate.right(), layout.width);
      }
}

}  // namespace
}  // namespace hackle
