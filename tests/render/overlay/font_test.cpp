// SPDX-License-Identifier: MIT
#include "render/overlay/font.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"

namespace hackle {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

// If a font is missing, Cairo silently takes another.
TEST(Font, SaysWhichPackageIsMissing) {
  try {
    Font("No Such Family");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    EXPECT_THAT(error.what(), HasSubstr("fonts-dejavu-core"));
  }
}

TEST(Font, TextsThatFitStayAsTheyAre) {
  const Font font;
  const double width = font.width_of("Duran 50 glass", 20.0);
  EXPECT_EQ(font.fitting("Duran 50 glass", 20.0, width), "Duran 50 glass");
}

TEST(Font, LongerOnesEndInAnEllipsisBetweenCharacters) {
  const Font font;
  for (int width = 0; width < 170; ++width) {
    const std::string text = font.fitting("µµµµ ßßßß µµµµ ßßßß µµµµ", 14.0, width);
    EXPECT_LE(font.width_of(text, 14.0), width);
    if (text.empty()) continue;
    EXPECT_THAT(text, EndsWith("…"));
    EXPECT_EQ(text.find('?'), std::string::npos) << "half a character: " << text;
  }
  EXPECT_NE(font.fitting("µµµµ ßßßß µµµµ", 14.0, 60.0), "");
}

TEST(Font, AnEndlessTextTakesNoTime) {
  const Font font;
  const std::string text = font.fitting(std::string(1'000'000, 'i'), 14.0, 100.0);
  EXPECT_THAT(text, EndsWith("…"));
  EXPECT_LT(text.size(), 60U);
}

TEST(Font, WhatCannotBeDrawnIsReplaced) {
  const Font font;
  EXPECT_EQ(font.place("a\nb", 0, 0, 12.0, 0.0, {}).text, "a b");
  EXPECT_EQ(font.place("a\xff", 0, 0, 12.0, 0.0, {}).text, "a?");
  EXPECT_EQ(font.place("a…", 0, 0, 12.0, 0.0, {}).text, "a…");
}

TEST(Font, TextsBeginOnWholePixels) {
  const Font font;
  for (const double anchor : {0.0, 0.5, 1.0}) {
    const PlacedText text = font.place("edge", 100.3, 20.6, 13.0, anchor, {});
    EXPECT_EQ(text.x, std::round(text.x));
    EXPECT_EQ(text.y, 21.0);
    EXPECT_NEAR(text.x + anchor * font.width_of("edge", 13.0), 100.3, 0.5);
  }
}

}  // namespace
}  // namespace hackle
