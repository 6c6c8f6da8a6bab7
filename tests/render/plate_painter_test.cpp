// SPDX-License-Identifier: MIT
#include "render/plate_painter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "measure/links.hpp"
#include "render/camera.hpp"
#include "render/cell_mesh.hpp"
#include "render/colour_map.hpp"
#include "render/overlay/layout.hpp"
#include "render/overlay/overlay.hpp"
#include "render/theme.hpp"
#include "support/pixels.hpp"

namespace hackle {
namespace {

PictureStyle style(int nx, int ny, int width = 640) {
  PictureStyle style;
  style.grid = {nx, ny, 1e-3, {0.5e-3 * nx, 0.5e-3 * ny}};
  style.width = width;
  return style;
}

Shot shot(const PictureStyle& style, float value, double time = 0.0) {
  Shot shot;
  shot.values.assign(style.grid.nodes(), value);
  shot.time = time;
  return shot;
}

Colour pixel(const Image& image, int x, int y) {
  const auto* at = &image.pixels[static_cast<std::size_t>(y * image.stride() + 4 * x)];
  return {at[2], at[1], at[0]};
}

// Returns the pixel at the centre of a cell.
Colour cell(const Image& image, const PictureStyle& style, int i, int j) {
  const Rectangle plate = make_layout(style.grid, style.width).plate;
  const double x = (i + 0.5) / style.grid.nx, y = 1.0 - (j + 0.5) / style.grid.ny;
  return pixel(image, plate.x + static_cast<int>(x * plate.width),
               plate.y + static_cast<int>(y * plate.height));
}

void expect_near(Colour seen, Colour wanted) {
  EXPECT_NEAR(seen.red, wanted.red, 2);
  EXPECT_NEAR(seen.green, wanted.green, 2);
  EXPECT_NEAR(seen.blue, wanted.blue, 2);
}

TEST(PlatePainter, GivesEveryValueItsColour) {
  const PictureStyle s = style(16, 8);
  Shot f = shot(s, 0.0F);
  for (int i = 0; i < 16; ++i) f.values[s.grid.index(i, 3)] = static_cast<float>(i) / 30.0F;
  const Image image = PlatePainter(s).paint(f);
  const ColourMap map = load_colour_map("damage");
  for (int i = 0; i < 16; ++i)
    expect_near(cell(image, s, i, 3), map.colours[static_cast<std::size_t>(i * 17)]);
}

TEST(PlatePainter, ClampsValuesOutsideTheRange) {
  const PictureStyle s = style(4, 4);
  Shot f = shot(s, 0.0F);
  f.values[0] = -7.0F;
  f.values[1] = std::numeric_limits<float>::infinity();
  const Image image = PlatePainter(s).paint(f);
  const ColourMap map = load_colour_map("damage");
  expect_near(cell(image, s, 0, 0), map.colours.front());
  expect_near(cell(image, s, 1, 0), map.colours.back());
}

TEST(PlatePainter, AMeanIsTheMeanOfTheCellsUnderAPixel) {
  PictureStyle s = style(4000, 1600, 640);
  s.field.sampling = Sampling::mean;
  s.field.min = -1.0;
  s.field.max = 1.0;
  Shot f = shot(s, 0.0F);
  for (int j = 0; j < s.grid.ny; ++j)
    for (int i = 0; i < s.grid.nx; ++i)
      f.values[s.grid.index(i, j)] = (i + j) % 2 == 0 ? -0.5F : 0.5F;
  const ColourMap map = load_colour_map("damage");
  const Colour seen = cell(PlatePainter(s).paint(f), s, 2000, 800);
  // Of 7 x 7 cells one value may have one cell more: 0.5/49 of a range of 2 is less than two of the
  // map's 256 colours.
  EXPECT_GE(seen.red, std::min(map.colours[126].red, map.colours[130].red));
  EXPECT_LE(seen.red, std::max(map.colours[126].red, map.colours[130].red));
}

TEST(PlatePainter, ALogarithmicScaleHasADecadeForADecade) {
  PictureStyle s = style(5, 4);
  s.field.logarithmic = true;
  s.field.min = 1.0;
  s.field.max = 1e4;
  Shot f = shot(s, 0.0F);
  for (int i = 0; i < 5; ++i) f.values[s.grid.index(i, 1)] = std::pow(10.0F, static_cast<float>(i));
  const Image image = PlatePainter(s).paint(f);
  const ColourMap map = load_colour_map("damage");
  for (int i = 0; i < 5; ++i)
    expect_near(cell(image, s, i, 1), map.colours[static_cast<std::size_t>(i * 255 / 4)]);
  expect_near(cell(image, s, 0, 0), map.colours.front());
}

TEST(PlatePainter, CracksAreGapsAndDamageAsOfARoughFaceIsNot) {
  PictureStyle s = style(8, 8);
  Shot f = shot(s, 0.5F);
  f.gaps.assign(f.values.size(), 26);  // 0.1
  f.gaps[s.grid.index(2, 1)] = 105;    // 20 of 48 bonds: the side of a straight crack
  const Image image = PlatePainter(s).paint(f);
  expect_near(cell(image, s, 2, 1), background_colour);
  expect_near(cell(image, s, 3, 1), load_colour_map("damage").colours.back());
}

// Both the open crack and the plate ahead of it would be white on a light ground.
TEST(PlatePainter, CracksAreDarkOnALightGround) {
  PictureStyle s = style(8, 8);
  s.background = Background::light;
  s.field.colour_map = "ember";
  Shot f = shot(s, 0.0F);
  f.gaps.assign(f.values.size(), 0);
  f.gaps[s.grid.index(2, 1)] = 105;
  const Image image = PlatePainter(s).paint(f);
  expect_near(cell(image, s, 2, 1), theme_of(Background::light).gap);
  expect_near(cell(image, s, 3, 1), load_colour_map("ember").colours.front());
}

// Neither a bond nor damage decides whether a node is drawn, only whether there is material.
TEST(PlatePainter, EveryNodeHasItsDot) {
  PictureStyle s = style(8, 6);
  Shot f = shot(s, 0.0F);
  f.values[s.grid.index(5, 2)] = std::nanf("");
  f.bonds = {{1, 1, 0, 1, true}, {2, 2, 1, 0, false}};
  const Image without = PlatePainter(s).paint(f);
  s.bonds = true;
  const Image image = PlatePainter(s).paint(f);
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 8; ++i) {
      const bool is_void = i == 5 && j == 2;
      expect_near(cell(without, s, i, j),
                  is_void ? background_colour : load_colour_map("damage").colours.front());
      expect_near(cell(image, s, i, j), is_void ? background_colour : Colour{255, 255, 255});
    }
}

// The range of a film jumps where what is seen no longer fits, and stays as it is from then on.
TEST(PlatePainter, ARangeThatWidensStaysWide) {
  PictureStyle s = style(8, 8);
  s.field.max = 1.0;
  s.field.widens = true;
  const ColourMap map = load_colour_map("damage");
  PlatePainter painter(s);
  const auto seen = [&](float value) { return cell(painter.paint(shot(s, value)), s, 3, 3); };
  expect_near(seen(1.0F), map.colours[255]);
  expect_near(seen(4.0F), map.colours[204]);  // of a range of 5
  expect_near(seen(1.0F), map.colours[51]);
  expect_near(seen(100.0F), map.colours[255]);
  expect_near(seen(10.0F), map.colours[25]);
}

// Beside the bar, where nothing else is: above its middle line at the right end.
TEST(PlatePainter, MarksTheBarWhereValuesLieBeyond) {
  PictureStyle s = style(8, 8);
  const Rectangle bar = layout_of(s).bars.at(0).colours;
  const auto beside = [&](float value) {
    return pixel(PlatePainter(s).paint(shot(s, value)), bar.right() + 2, bar.y + bar.height / 2);
  };
  expect_near(beside(0.5F), background_colour);
  expect_near(beside(0.6F), load_colour_map("damage").colours.back());
}

// Values 0 left and 1 right of the middle: a smooth picture has a value between them where they
// meet, unless no bond joins the two halves.
TEST(PlatePainter, ASmoothPictureInterpolatesButNotAcrossCracks) {
  PictureStyle s = style(8, 8);
  s.smooth = true;
  s.field.max = 1.0;
  Shot f = shot(s, 0.0F);
  f.links.assign(s.grid.nodes(), Link::right | Link::above_right | Link::above | Link::above_left);
  for (int j = 0; j < 8; ++j)
    for (int i = 4; i < 8; ++i) f.values[s.grid.index(i, j)] = 1.0F;
  const ColourMap map = load_colour_map("damage");
  const Rectangle plate = layout_of(s).plate;
  const auto beside_the_middle = [&](const Shot& shown, int px) {
    return pixel(PlatePainter(s).paint(shown), plate.x + plate.width / 2 + px,
                 plate.y + plate.height / 2);
  };
  const double share = 0.5 + 0.5 / (plate.width / 8);  // of a cell, half a px from the middle
  expect_near(beside_the_middle(f, 0), map.colours[static_cast<std::size_t>(255.0 * share)]);
  for (int j = 0; j < 8; ++j) {
    f.links[s.grid.index(3, j)] = Link::above | Link::above_left;
    f.links[s.grid.index(4, j)] = Link::right | Link::above | Link::above_right;
  }
  expect_near(beside_the_middle(f, 0), map.colours.back());
  expect_near(beside_the_middle(f, -1), map.colours.front());
}

// A plate that flies off its frame, as in a film whose frame was chosen before: it is smaller from
// then on, and whole.
TEST(PlatePainter, AWindowGrowsAroundADisplacedPlate) {
  PictureStyle s = style(16, 8);
  s.magnification = 100.0;
  Shot f = shot(s, 1.0F);
  f.links.assign(s.grid.nodes(), Link::right | Link::above_right | Link::above | Link::above_left);
  f.displacement.assign(2 * s.grid.nodes(), 0.0F);
  for (std::size_t node = 0; node < s.grid.nodes(); ++node) f.displacement[2 * node] = -60e-6F;
  const Rectangle plate = layout_of(s).plate;
  const Colour bright = load_colour_map("damage").colours.back();
  const auto seen = [&](const Image& image) {
    return plate.width * plate.height - test::differing(image, plate, bright);
  };
  const int cut = seen(PlatePainter(s).paint(f));
  EXPECT_NEAR(cut, 10.0 / 16.0 * plate.width * plate.height, 2.0 * plate.height);
  s.encloses = true;
  PlatePainter painter(s);
  const Image whole = painter.paint(f);
  // 6 cells of 16 to the left: a window of 24 by 12 cells is 4 short, one of 36 by 18 is not.
  EXPECT_NEAR(seen(whole), 16.0 * 8.0 / (36.0 * 18.0) * plate.width * plate.height,
              0.02 * plate.width * plate.height);
  std::ranges::fill(f.displacement, 0.0F);
  EXPECT_NEAR(seen(painter.paint(f)), seen(whole), 0.005 * plate.width * plate.height);
}

TEST(PlatePainter, FringesAreDarkAtWholeOrders) {
  PictureStyle s = style(9, 4);
  s.field.colour_map = fringes_name;
  s.field.sampling = Sampling::mean;
  s.field.max = 4.0;
  Shot f = shot(s, 0.0F);
  for (int i = 0; i < 9; ++i) f.values[s.grid.index(i, 1)] = 0.5F * static_cast<float>(i);
  const Image image = PlatePainter(s).paint(f);
  for (int i = 0; i < 9; ++i) {
    const int light = cell(image, s, i, 1).green;
    if (i % 2 == 0)
      EXPECT_LT(light, 12) << i;
    else
      EXPECT_GT(light, 250) << i;
  }
}

TEST(PlatePainter, ShowsBackgroundWhereThereIsNoMaterial) {
  const PictureStyle s = style(4, 4);
  Shot f = shot(s, 0.2F);
  f.values[s.grid.index(2, 1)] = std::nanf("");
  expect_near(cell(PlatePainter(s).paint(f), s, 2, 1), background_colour);
}

TEST(PlatePainter, OnATransparentGroundThePlateAloneIsOpaque) {
  PictureStyle s = style(4, 4);
  s.background = Background::transparent;
  Shot f = shot(s, 0.2F);
  f.values[s.grid.index(2, 1)] = std::nanf("");
  const Image image = PlatePainter(s).paint(f);
  const Rectangle plate = layout_of(s).plate;
  const auto alpha = [&](int x, int y) {
    return static_cast<int>(image.pixels[static_cast<std::size_t>(y * image.stride() + 4 * x + 3)]);
  };
  EXPECT_EQ(alpha(plate.x + plate.width / 8, plate.y + plate.height / 8), 255);
  EXPECT_EQ(alpha(plate.x + plate.width * 5 / 8, plate.y + plate.height * 5 / 8), 0);
  EXPECT_EQ(alpha(plate.x / 2, plate.y + 10), 0);
}

TEST(PlatePainter, TheFirstRowIsAtTheBottom) {
  const PictureStyle s = style(4, 4);
  Shot f = shot(s, 0.0F);
  f.values[s.grid.index(0, 0)] = 1.0F;
  const Image image = PlatePainter(s).paint(f);
  const Rectangle plate = make_layout(s.grid, s.width).plate;
  const Colour bright = load_colour_map("damage").colours.back();
  expect_near(pixel(image, plate.x + 2, plate.bottom() - 3), bright);
}

TEST(PlatePainter, ACrackOneCellWideStaysVisibleWhenCellsAreSmallerThanPixels) {
  const PictureStyle s = style(4000, 1600, 640);  // seven cells per pixel
  Shot f = shot(s, 0.0F);
  for (int i = 0; i < 4000; ++i) f.values[s.grid.index(i, 803)] = 1.0F;
  const Image image = PlatePainter(s).paint(f);
  const Rectangle plate = make_layout(s.grid, s.width).plate;
  const Colour bright = load_colour_map("damage").colours.back();
  for (int x = plate.x + 1; x < plate.right() - 1; x += 7) {
    int seen = 0;
    for (int y = plate.y; y < plate.bottom(); ++y) seen += pixel(image, x, y) == bright ? 1 : 0;
    EXPECT_GE(seen, 1) << x;
    EXPECT_LE(seen, 2) << x;
  }
}

TEST(PlatePainter, AWindowShowsItsCellsAndBackgroundBeyondThePlate) {
  PictureStyle s = style(16, 8);
  Shot f = shot(s, 0.0F);
  for (int i = 0; i < 16; ++i) f.values[s.grid.index(i, 3)] = static_cast<float>(i) / 30.0F;
  s.window = Window{12, 2, 8, 4};
  const Image image = PlatePainter(s).paint(f);
  PictureStyle seen = s;
  seen.grid = part(s.grid, *s.window);
  const ColourMap map = load_colour_map("damage");
  for (int i = 0; i < 4; ++i) {
    expect_near(cell(image, seen, i, 1), map.colours[static_cast<std::size_t>((12 + i) * 17)]);
    expect_near(cell(image, seen, i, 2), map.colours.front());
    expect_near(cell(image, seen, 4 + i, 1), background_colour);
  }
}

TEST(PlatePainter, AWindowOfEverythingIsTheWholePlate) {
  PictureStyle s = style(40, 16);
  Shot f = shot(s, 0.1F);
  for (std::size_t k = 0; k < f.values.size(); ++k) f.values[k] = static_cast<float>(k % 50) / 100;
  const Image whole = PlatePainter(s).paint(f);
  s.window = Window{0, 0, 40, 16};
  EXPECT_EQ(PlatePainter(s).paint(f).pixels, whole.pixels);
}

// Whole rows move up by two cells at the crack between rows 7 and 8.
TEST(PlatePainter, ADisplacedPlateOpensAtItsCrack) {
  PictureStyle s = style(24, 16);
  s.window = Window{-4, -4, 32, 24};
  s.magnification = 1000.0;
  Shot f = shot(s, 0.5F);
  f.displacement.assign(2 * s.grid.nodes(), 0.0F);
  f.links.assign(s.grid.nodes(), Link::right | Link::above | Link::above_left | Link::above_right);
  for (int i = 0; i < 24; ++i) {
    f.links[s.grid.index(i, 7)] = Link::right;
    for (int j = 8; j < 16; ++j) f.displacement[2 * s.grid.index(i, j) + 1] = 2e-6F;
  }
  const Image image = PlatePainter(s).paint(f);
  PictureStyle seen = s;
  seen.grid = part(s.grid, *s.window);
  const Colour bright = load_colour_map("damage").colours.back();
  for (int i = 4; i < 28; ++i)
    for (int j = 0; j < 24; ++j)
      expect_near(cell(image, seen, i, j),
                  (j >= 4 && j < 12) || (j >= 14 && j < 22) ? bright : background_colour);
}

TEST(PlatePainter, APlateOnEndIsTheSamePlate) {
  PictureStyle s = style(16, 8);
  Shot f = shot(s, 0.0F);
  f.values[s.grid.index(15, 0)] = 1.0F;
  s.rotation = std::numbers::pi / 2;
  s.window = whole_window(s.grid, s.rotation, 0);
  const Image image = PlatePainter(s).paint(f);
  PictureStyle seen = s;
  seen.grid = {8, 16, s.grid.dx, s.grid.centre};
  const ColourMap map = load_colour_map("damage");
  // the lower right goes to the upper right
  expect_near(cell(image, seen, 7, 15), map.colours.back());
  expect_near(cell(image, seen, 0, 15), map.colours.front());
  expect_near(cell(image, seen, 7, 0), map.colours.front());
}

// A cell at 45 degrees has intermediate colours somewhere along its edges.
TEST(PlatePainter, EdgesOfATurnedPlateAreSmooth) {
  PictureStyle s = style(16, 8);
  s.rotation = std::numbers::pi / 4;
  s.window = whole_window(s.grid, s.rotation, 0);
  const Image image = PlatePainter(s).paint(shot(s, 0.5F));
  const Colour bright = load_colour_map("damage").colours.back();
  int between = 0;
  const Rectangle plate = make_layout(part(s.grid, *s.window), s.width).plate;
  for (int y = plate.y + 2; y < plate.bottom() - 2; ++y)
    for (int x = plate.x + 2; x < plate.right() - 2; ++x) {
      const int red = pixel(image, x, y).red;
      between += red > background_colour.red + 20 && red < bright.red - 20 ? 1 : 0;
    }
  EXPECT_GT(between, plate.width);
}

TEST(PlatePainter, CellsWithoutMaterialHideNothingWhenTheyAreDisplaced) {
  PictureStyle s = style(8, 8);
  s.magnification = 1.0;
  Shot f = shot(s, 0.5F);
  f.displacement.assign(2 * s.grid.nodes(), 0.0F);
  f.links.assign(s.grid.nodes(), 0);
  // The void cell is drawn last, displaced onto its neighbour.
  f.values[s.grid.index(7, 7)] = std::nanf("");
  f.displacement[2 * s.grid.index(7, 7)] = -1e-3F;
  const Image image = PlatePainter(s).paint(f);
  expect_near(cell(image, s, 6, 7), load_colour_map("damage").colours.back());
  expect_near(cell(image, s, 7, 7), background_colour);
}

// Values 0 and 1 of both fields, each in its own colours.
PictureStyle two_fields(Arrangement arrangement) {
  PictureStyle s = style(8, 8);
  s.second = FieldStyle{};
  s.second->colour_map = "viridis";
  s.second->max = 1.0;
  s.arrangement = arrangement;
  return s;
}

TEST(PlatePainter, ASecondFieldIsSeenInItsHalf) {
  const Colour first = load_colour_map("damage").colours.back();
  const Colour second = load_colour_map("viridis").colours.back();
  for (const Arrangement arrangement : {Arrangement::below, Arrangement::right}) {
    const PictureStyle s = two_fields(arrangement);
    Shot f = shot(s, 1.0F);
    f.second.assign(s.grid.nodes(), 1.0F);
    const Image image = PlatePainter(s).paint(f);
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 8; ++i) {
        const bool is_second = arrangement == Arrangement::below ? j < 4 : i >= 4;
        expect_near(cell(image, s, i, j), is_second ? second : first);
      }
  }
}

TEST(PlatePainter, HalvesMeetAtTheMidlineOfThePlateNotOfTheWindow) {
  PictureStyle s = two_fields(Arrangement::below);
  s.window = Window{0, 0, 6, 6};
  Shot f = shot(s, 1.0F);
  f.second.assign(s.grid.nodes(), 1.0F);
  PictureStyle seen = s;
  seen.grid = part(s.grid, *s.window);
  const Image image = PlatePainter(s).paint(f);
  expect_near(cell(image, seen, 2, 3), load_colour_map("viridis").colours.back());
  expect_near(cell(image, seen, 2, 4), load_colour_map("damage").colours.back());
}

TEST(PlatePainter, ASecondFieldOverTheFirstIsOpaqueWhereItIsLarge) {
  const PictureStyle s = two_fields(Arrangement::over);
  Shot f = shot(s, 1.0F);
  f.second.assign(s.grid.nodes(), 0.0F);
  f.second[s.grid.index(3, 3)] = 1.0F;
  const Image image = PlatePainter(s).paint(f);
  expect_near(cell(image, s, 3, 3), load_colour_map("viridis").colours.back());
  expect_near(cell(image, s, 4, 3), load_colour_map("damage").colours.back());
}

TEST(PlatePainter, ATransparentBackgroundHasNoColour) {
  PictureStyle s = style(4, 4);
  s.background = Background::transparent;
  Shot f = shot(s, 0.5F);
  f.values[s.grid.index(2, 1)] = std::nanf("");
  const Image image = PlatePainter(s).paint(f);
  const Rectangle plate = make_layout(s.grid, s.width).plate;
  const auto alpha = [&](double x, double y) {
    const int column = plate.x + static_cast<int>(x * plate.width);
    const int row = plate.bottom() - 1 - static_cast<int>(y * plate.height);
    return image.pixels[static_cast<std::size_t>(row * image.stride() + 4 * column + 3)];
  };
  EXPECT_EQ(alpha(0.625, 0.375), 0);
  EXPECT_EQ(alpha(0.375, 0.375), 255);
  EXPECT_EQ(image.pixels[3], 0);
}

TEST(PlatePainter, AShotLooksWhereItsWindowIs) {
  PictureStyle s = style(16, 8);
  Shot f = shot(s, 0.0F);
  f.values[s.grid.index(12, 3)] = 1.0F;
  s.window = Window{0, 2, 8, 4};
  PlatePainter painter(s);
  f.window = Window{8, 2, 8, 4};
  PictureStyle seen = s;
  seen.grid = part(s.grid, *f.window);
  expect_near(cell(painter.paint(f), seen, 4, 1), load_colour_map("damage").colours.back());
}

TEST(PlatePainter, ALatticeOfMoreNodesThanATextureTakesIsPainted) {
  const PictureStyle s = style(40000, 4, 640);
  Shot f = shot(s, 0.0F);
  f.values[s.grid.index(39999, 0)] = 1.0F;
  const Image image = PlatePainter(s).paint(f);
  const Rectangle plate = make_layout(s.grid, s.width).plate;
  expect_near(pixel(image, plate.right() - 1, plate.bottom() - 1),
              load_colour_map("damage").colours.back());
}

TEST(PlatePainter, ABarePictureIsFilledToItsEdges) {
  PictureStyle s = style(4, 4, 30);
  s.bare_height = 10;
  const Shot f = shot(s, 0.5F);
  const Image image = PlatePainter(s).paint(f);
  ASSERT_EQ(image.width, 30);
  ASSERT_EQ(image.height, 10);
  const Colour bright = load_colour_map("damage").colours.back();
  for (const int x : {0, 29})
    for (const int y : {0, 9}) expect_near(pixel(image, x, y), bright);
}

TEST(PlatePainter, ABarePictureShowsDiscsInTheirPlace) {
  PictureStyle s = style(40, 20, 80);
  s.bare_height = 20;  // half as many px per cell upwards
  Shot f = shot(s, 0.0F);
  f.discs = {{{0.030, 0.015}, 0.004}};
  const Image image = PlatePainter(s).paint(f);
  const Colour ground = load_colour_map("damage").colours.front();
  EXPECT_FALSE(pixel(image, 60, 5) == ground);
  EXPECT_FALSE(pixel(image, 54, 5) == ground);
  expect_near(pixel(image, 60, 11), ground);
  expect_near(pixel(image, 40, 5), ground);
}

TEST(PlatePainter, ASymmetricFieldGivesASymmetricPlate) {
  for (const int nx : {50, 51, 1111}) {
    const PictureStyle s = style(nx, nx / 2);
    Shot f = shot(s, 0.0F);
    for (int j = 0; j < s.grid.ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const int from_middle = std::abs(2 * j + 1 - s.grid.ny);
        f.values[s.grid.index(i, j)] = static_cast<float>((i * 7 + from_middle * 13) % 50) / 100.0F;
      }
    const Image image = PlatePainter(s).paint(f);
    const Rectangle plate = make_layout(s.grid, s.width).plate;
    int different = 0;
    for (int y = 0; y < plate.height / 2; ++y)
      for (int x = 0; x < plate.width; ++x)
        different += pixel(image, plate.x + x, plate.y + y) ==
                             pixel(image, plate.x + x, plate.bottom() - 1 - y)
                         ? 0
                         : 1;
    EXPECT_EQ(different, 0) << nx;
  }
}

TEST(PlatePainter, PaintsTheSameTwice) {
  const PictureStyle s = style(30, 20);
  PlatePainter painter(s);
  const Image first = painter.paint(shot(s, 0.3F, 1e-6));
  painter.paint(shot(s, 0.1F, 2e-6));
  EXPECT_EQ(painter.paint(shot(s, 0.3F, 1e-6)).pixels, first.pixels);
}

TEST(PlatePainter, ManyCanFollowAndLiveBesideOneAnother) {
  const PictureStyle small = style(4, 4, 320), large = style(40, 10, 1280);
  PlatePainter one(small);
  const Image before = one.paint(shot(small, 0.3F, 0.0));
  {
    PlatePainter other(large);
    EXPECT_EQ(other.paint(shot(large, 0.3F, 0.0)).width, 1280);
  }
  EXPECT_EQ(one.paint(shot(small, 0.3F, 0.0)).pixels, before.pixels);
}

// With square cells and a turned plate; each library rounds in its own way.
TEST(PlatePainter, BothLibrariesPaintTheSamePicture) {
  for (const double rotation : {0.0, 0.3}) {
    PictureStyle s = style(60, 24);
    s.rotation = rotation;
    s.window = whole_window(s.grid, rotation, 1);
    Shot f = shot(s, 0.0F);
    for (std::size_t k = 0; k < f.values.size(); ++k)
      f.values[k] = static_cast<float>(k % 50) / 100;
    const Image one = PlatePainter(s).paint(f);
    setenv("HACKLE_GL", "egl", 1);
    const Image other = PlatePainter(s).paint(f);
    unsetenv("HACKLE_GL");
    ASSERT_EQ(one.pixels.size(), other.pixels.size());
    std::size_t different = 0;
    for (std::size_t at = 0; at < one.pixels.size(); ++at)
      different += std::abs(one.pixels[at] - other.pixels[at]) > 2 ? 1 : 0;
    EXPECT_EQ(different, 0U);
  }
}

}  // namespace
}  // namespace hackle
