// SPDX-License-Identifier: MIT
#include "render/overlay/overlay.hpp"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "support/pixels.hpp"

namespace hackle {
namespace {

using test::differing;
using test::lit;

const Grid paper_plate{200, 80, 0.5e-3, {0.05, 0.02}};

Chart chart(const char* heading, double now) {
  return {heading, "J/m", 30e-6, {{"kinetic", "", {{now, 5.0}}}, {"strain", "", {{now, 2.0}}}}};
}

Moment moment(double time) {
  return {time, {}, chart("load", time), chart("energy", time)};
}

Camera camera(const Layout& layout) {
  return {paper_plate, {0, 0, paper_plate.nx, paper_plate.ny}, 0.0, layout.plate};
}

// Draws the overlay on a black picture.
Image drawn(const OverlayText& text, int width, const Moment& what) {
  const Layout layout = make_layout(paper_plate, width, text);
  Image image(layout.width, layout.height);
  Overlay(layout, text, {load_colour_map("damage")}, camera(layout).pixels_a_metre().x())
      .draw(image, {camera(layout)}, what);
  return image;
}

OverlayText text() {
  OverlayText text;
  text.title = "A title";
  text.bars[0].max = 0.5;
  return text;
}

class OverlayAt : public testing::TestWithParam<int> {};

TEST_P(OverlayAt, DrawsEveryPartWhereItBelongs) {
  OverlayText all = text();
  all.note = "deformed × 100";
  all.slow_motion = 1e5;
  all.parts.load_curve = all.parts.energy = true;
  const Layout layout = make_layout(paper_plate, GetParam(), all);
  const Image image = drawn(all, GetParam(), moment(2e-6));
  const Colour ground = background_colour;
  for (const Rectangle& area :
       {layout.title, layout.note, layout.clock, layout.slow_motion, layout.bars[0].label,
        layout.bars[0].ticks, layout.scale, layout.load_curve, layout.energy})
    EXPECT_GT(differing(image, area, ground), 0) << area.x << ", " << area.y;
  // Every row of the bar shows colours, never the background.
  EXPECT_EQ(differing(image, layout.bars[0].colours, ground),
            layout.bars[0].colours.width * layout.bars[0].colours.height);
  EXPECT_EQ(lit(image, layout.plate), 0) << "the plate is painted over";
}

// A part that is switched off leaves no trace, and all other parts that have not moved are
// unchanged.
TEST_P(OverlayAt, PartsAreSwitchable) {
  const Moment what = moment(2e-6);
  const OverlayText full = text();
  const Layout layout = make_layout(paper_plate, GetParam(), full);
  const Image whole = drawn(full, GetParam(), what);
  struct Case {
    const char* name;
    void (*drop)(OverlayText&);
    Rectangle area;
  };
  const Rectangle bar{0, layout.foot, layout.scale.x, layout.height - layout.foot};
  for (const Case& c :
       {Case{"title", [](OverlayText& t) { t.title.clear(); }, layout.title},
        {"clock", [](OverlayText& t) { t.parts.clock = false; }, layout.clock},
        {"bar", [](OverlayText& t) { t.parts.bar = false; }, bar},
        {"scale bar", [](OverlayText& t) { t.parts.scale_bar = false; }, layout.scale}}) {
    OverlayText less = full;
    c.drop(less);
    const Image image = drawn(less, GetParam(), what);
    ASSERT_EQ(image.pixels.size(), whole.pixels.size()) << c.name;
    EXPECT_EQ(differing(image, c.area, background_colour), 0) << c.name;
    EXPECT_GT(differing(whole, c.area, background_colour), 0) << c.name;
    EXPECT_EQ(test::differing_outside(image, whole, c.area), 0) << c.name;
  }
}

TEST_P(OverlayAt, StaysInsideThePicture) {
  const Image image = drawn(text(), GetParam(), moment(1e-4));
  const int w = image.width, h = image.height;
  for (const Rectangle& edge :
       {Rectangle{0, 0, w, 1}, {0, h - 1, w, 1}, {0, 0, 1, h}, {w - 1, 0, 1, h}})
    EXPECT_EQ(test::count_pixels(image, edge,
                                 [&](int x, int y) {
                                   const auto* at = test::pixel(image, x, y);
                                   const Colour colour{at[2], at[1], at[0]};
                                   return !(colour == background_colour || colour == Colour{});
                                 }),
              0);
}

// A picture keeps its transparency where nothing is drawn; texts are full colours times their
// alpha.
TEST_P(OverlayAt, ATransparentGroundStaysTransparent) {
  OverlayText clear = text();
  clear.background = Background::transparent;
  const Image image = drawn(clear, GetParam(), moment(1e-6));
  const Layout layout = make_layout(paper_plate, GetParam(), clear);
  int seen_through = 0, opaque = 0, between = 0;
  const int first = layout.bars[0].label.y * image.stride(),
            last = layout.bars[0].label.bottom() * image.stride();
  for (int k = first; k < last; k += 4) {
    const auto* pixel = &image.pixels[static_cast<std::size_t>(k)];
    (pixel[3] == 0 ? seen_through : pixel[3] == 255 ? opaque : between) += 1;
    for (int part = 0; part < 3; ++part) EXPECT_LE(pixel[part], pixel[3]);
  }
  EXPECT_GT(seen_through, image.width);
  EXPECT_GE(opaque, layout.bars[0].colours.width);
  EXPECT_GT(between, 0) << "texts are smooth";
}

TEST_P(OverlayAt, AMovieIsDrawnAsSinglePicturesAre) {
  const Layout layout = make_layout(paper_plate, GetParam(), text());
  Overlay overlay(layout, text(), {load_colour_map("damage")}, camera(layout).pixels_a_metre().x());
  for (const double time : {0.0, 1e-6, 12e-6}) {
    Image image(layout.width, layout.height);
    overlay.draw(image, {camera(layout)}, moment(time));
    EXPECT_EQ(image.pixels, drawn(text(), GetParam(), moment(time)).pixels) << time;
  }
}

TEST_P(OverlayAt, DrawsDiscsWhereTheyAreAndNowhereElse) {
  const Layout layout = make_layout(paper_plate, GetParam());
  const Layout bare = bare_layout(layout.plate.width, layout.plate.height);
  Overlay overlay(bare, {}, {}, camera(bare).pixels_a_metre().x());
  Image image(bare.width, bare.height);
  overlay.draw(image, {camera(bare)}, {});
  EXPECT_EQ(lit(image, bare.plate), 0);
  // A tenth of the plate's width across, at its centre: pi/4 of the square around it, and its rim.
  overlay.draw(image, {camera(bare)}, {0.0, {{{0.05, 0.02}, 0.005}}, {}, {}});
  const double width = 0.1 * bare.plate.width, area = 0.25 * std::numbers::pi * width * width;
  EXPECT_NEAR(lit(image, bare.plate), area, 2.0 * std::numbers::pi * width);
  const int x = bare.width / 2, y = bare.height / 2, r = static_cast<int>(0.5 * width) + 2;
  EXPECT_EQ(lit(image, {x - r, y - r, 2 * r, 2 * r}), lit(image, bare.plate));
}

TEST_P(OverlayAt, NeitherCaptionNorLegendArePaintedOver) {
  const Layout layout = make_layout(paper_plate, GetParam(), text());
  Moment large = moment(1e-6);
  const Image plain = drawn(text(), GetParam(), large);
  large.discs = {{{-0.5, -0.5}, 10.0}};
  const Image image = drawn(text(), GetParam(), large);
  const Rectangle between{0, layout.caption.bottom(), layout.width,
                          layout.foot - layout.caption.bottom()};
  EXPECT_EQ(test::differing_outside(image, plain, between), 0);
  EXPECT_GT(lit(image, layout.plate), 0);
}

TEST_P(OverlayAt, MarkersStandWhereTheyAreSaidToBe) {
  OverlayText marked = text();
  marked.parts.markers = {{{0.06, 0.03}, "tip"}, {{0.5, 0.5}, "not seen"}};
  const Layout layout = make_layout(paper_plate, GetParam(), marked);
  const Image image = drawn(marked, GetParam(), moment(0.0));
  const int x = layout.plate.x + layout.plate.width * 6 / 10,
            y = layout.plate.y + layout.plate.height / 4;
  const int size = static_cast<int>(3.0 * layout.small_font);
  EXPECT_GT(lit(image, {x, y, 1, 1}), 0);
  EXPECT_GT(lit(image, {x + 4, y - size / 3, size, size / 2}), 10) << "the label";
  EXPECT_EQ(lit(image, layout.plate), lit(image, {x - size, y - size, 3 * size, 2 * size}));
}

// Each is drawn by itself, not from where the one before ends.
TEST_P(OverlayAt, NothingLiesBetweenMarkers) {
  OverlayText marked = text();
  marked.parts.markers = {{{0.01, 0.01}, "a"}, {{0.09, 0.03}, "b"}};
  const Layout layout = make_layout(paper_plate, GetParam(), marked);
  const Rectangle& plate = layout.plate;
  const Rectangle between{plate.x + plate.width * 4 / 10, plate.y, plate.width * 2 / 10,
                          plate.height};
  EXPECT_EQ(lit(drawn(marked, GetParam(), moment(0.0)), between), 0);
}

INSTANTIATE_TEST_SUITE_P(Widths, OverlayAt, testing::Values(320, 640, 1280, 3840));

TEST(OverlayText, SaysTimesWithTwoDecimalsSoThatTheyDoNotDance) {
  EXPECT_EQ(time_text(0.0), "0.00 µs");
  EXPECT_EQ(time_text(22.5e-6), "22.50 µs");
  EXPECT_EQ(time_text(1.25e-3), "1.2500 ms");
  EXPECT_EQ(time_text(2.5), "2.5000 s");
}

TEST(OverlayText, SaysSlowMotionAsAFactor) {
  EXPECT_EQ(slow_motion_text(0.0), "");
  EXPECT_EQ(slow_motion_text(1.0 / (0.25e-6 * 30.0)), "slowed 133 000 times");
  EXPECT_EQ(slow_motion_text(12.5), "slowed 12.5 times");
  EXPECT_EQ(slow_motion_text(0.05), "sped up 20 times");
}

TEST(OverlayText, WritesUnitsAsPeopleDo) {
  EXPECT_EQ(printed_unit("us"), "µs");
  EXPECT_EQ(printed_unit("MPa"), "MPa");
  EXPECT_EQ(printed_unit("kJ/m3"), "kJ/m³");
}

}  // namespace
}  // namespace hackle
