// SPDX-License-Identifier: MIT
#include "render/overlay/scale_bar.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "support/pixels.hpp"

namespace hackle {
namespace {

// The line is as long as its text says, to a pixel at either end, at any scale.
TEST(ScaleBar, IsAsLongAsItSays) {
  const Font font;
  const struct {
    const char* unit;
    double metres;
  } units[] = {{" nm", 1e-9}, {" µm", 1e-6}, {" mm", 1e-3}, {" m", 1.0}};
  for (const double metres_per_pixel : {1e-9, 3e-7, 8e-5, 1.1e-4, 0.02, 5.0})
    for (const int width : {640, 1280}) {
      const Layout layout = make_layout({200, 80, 1e-3, {0, 0}}, width);
      const ScaleBar bar(layout, {}, font, metres_per_pixel);
      Image image(layout.width, layout.height);
      Canvas canvas(image);
      bar.draw(canvas);
      int first = layout.width, last = -1;
      for (int x = 0; x < layout.width; ++x)
        if (test::lit(image, {x, 0, 1, layout.height}) > 0) {
          first = std::min(first, x);
          last = std::max(last, x);
        }
      const std::string& text = bar.text().text;
      double metres = 0.0;
      for (const auto& unit : units)
        if (text.ends_with(unit.unit)) metres = std::stod(text) * unit.metres;
      EXPECT_NEAR(last - first + 1, metres / metres_per_pixel, 2.0) << text;
      // Inside its room, and not too short to be legible.
      EXPECT_LE(last, layout.scale.right());
      EXPECT_GE(first, layout.scale.x - 1);
      EXPECT_GT(last - first, 0.04 * layout.plate.width) << text;
      EXPECT_LT(last - first, 0.21 * layout.plate.width + 1) << text;
    }
}

}  // namespace
}  // namespace hackle
