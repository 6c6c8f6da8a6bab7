// SPDX-License-Identifier: MIT
#include "render/gl_context.hpp"

#include <cstdlib>

#include <GL/gl.h>
#include <gmock/gmock.h>

#include "base/error.hpp"

namespace hackle {
namespace {

TEST(GlContext, ClearsToBlueGreenRedAlpha) {
  GlContext context(4, 2);
  glClearColor(1.0F, 0.5F, 0.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  const Image& image = context.finish();
  ASSERT_EQ(image.pixels.size(), 32U);
  EXPECT_EQ(image.pixels[0], 0);
  EXPECT_NEAR(image.pixels[1], 128, 1);
  EXPECT_EQ(image.pixels[2], 255);
  EXPECT_EQ(image.pixels[3], 255);
}

TEST(GlContext, TheTopRowComesFirst) {
  GlContext context(4, 4);
  glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 3, 4, 1);  // the topmost row: OpenGL counts from the bottom
  glClearColor(1.0F, 1.0F, 1.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  const Image& image = context.finish();
  EXPECT_EQ(image.pixels[0], 255);
  EXPECT_EQ(image.pixels[4 * 4], 0);
}

TEST(GlContext, NamesWhatDraws) {
  EXPECT_FALSE(GlContext(4, 4).renderer().empty());
}

TEST(GlContext, RefusesTheDriverThatCrashes) {
  setenv("GALLIUM_DRIVER", "swr", 1);
  EXPECT_THROW(GlContext(4, 4), Error);
  unsetenv("GALLIUM_DRIVER");
}

}  // namespace
}  // namespace hackle
