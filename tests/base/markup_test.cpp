// SPDX-License-Identifier: MIT
#include "base/markup.hpp"

#include <gtest/gtest.h>

namespace hackle {
namespace {

TEST(Markup, MarkdownTakesNothingForMarkup) {
  EXPECT_EQ(markdown("2*MPa, next_step | <x>"), "2\\*MPa, next\\_step \\| \\<x\\>");
  EXPECT_EQ(markdown_code("a|b_c"), "`a\\|b_c`");
  EXPECT_EQ(markdown_code(""), "");
}

TEST(Markup, RoffTakesNothingForARequest) {
  EXPECT_EQ(roff(".TH"), "\\&.TH");
  EXPECT_EQ(roff("'quoted' a\\b"), "\\&'quoted' a\\eb");
  EXPECT_EQ(roff_code("--set"), "\\fB\\-\\-set\\fR");
  EXPECT_EQ(roff_example("a\n.b"), ".PP\n.RS 4\n.nf\na\n\\&.b\n.fi\n.RE\n");
}

TEST(Markup, XmlHasNoMarkupOfItsOwn) {
  EXPECT_EQ(xml("a<b & \"c\">"), "a&lt;b &amp; &quot;c&quot;&gt;");
  EXPECT_EQ(xml("plate 1.h5"), "plate 1.h5");
}

TEST(Markup, XmlIsReadBack) {
  for (const char* text : {"", "a<b & \"c\">", "&amp;", "&lt;&", "plate"})
    EXPECT_EQ(from_xml(xml(text)), text);
}

}  // namespace
}  // namespace hackle
