// SPDX-License-Identifier: MIT
#include "render/gl/gl_context.hpp"

#include <cstdlib>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "render/gl/gl_objects.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// For both libraries.
class GlContextOf : public testing::TestWithParam<GlLibrary> {};

TEST_P(GlContextOf, ClearsToBlueGreenRedAlpha) {
  GlContext context(4, 2, GetParam());
  const GlFunctions& gl = context.functions();
  gl.ClearColor(1.0F, 0.5F, 0.0F, 1.0F);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  const Image& image = context.finish();
  ASSERT_EQ(image.pixels.size(), 32U);
  EXPECT_EQ(image.pixels[0], 0);
  EXPECT_NEAR(image.pixels[1], 128, 1);
  EXPECT_EQ(image.pixels[2], 255);
  EXPECT_EQ(image.pixels[3], 255);
}

TEST_P(GlContextOf, TheTopRowComesFirst) {
  GlContext context(4, 4, GetParam());
  const GlFunctions& gl = context.functions();
  gl.ClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  const Texture white(gl);
  white.make_room(1, 1);
  const Framebuffer from(gl, white);
  gl.ClearColor(1.0F, 1.0F, 1.0F, 1.0F);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, from.id());
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, context.target());
  // The topmost row: OpenGL counts from the bottom.
  gl.BlitFramebuffer(0, 0, 1, 1, 0, 3, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  const Image& image = context.finish();
  EXPECT_EQ(image.pixels[0], 255);
  EXPECT_EQ(image.pixels[4 * 4], 0);
}

TEST_P(GlContextOf, NamesWhatDraws) {
  EXPECT_FALSE(GlContext(4, 4, GetParam()).renderer().empty());
}

TEST_P(GlContextOf, SeveralLiveSideBySide) {
  GlContext one(4, 4, GetParam());
  {
    GlContext other(8, 8, GetParam());
    other.functions().ClearColor(1.0F, 1.0F, 1.0F, 1.0F);
    other.functions().Clear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(other.finish().pixels.back(), 255);
  }
  one.make_current();
  one.functions().ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  one.functions().Clear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(one.finish().pixels.back(), 0);
}

INSTANTIATE_TEST_SUITE_P(Libraries, GlContextOf, testing::Values(GlLibrary::osmesa, GlLibrary::egl),
                         [](const auto& of) {
                           return std::string(gl_library_names[static_cast<std::size_t>(of.param)]);
                         });

TEST(GlContext, RefusesTheDriverThatCrashes) {
  setenv("GALLIUM_DRIVER", "swr", 1);
  EXPECT_THROW(GlContext(4, 4), Error);
  unsetenv("GALLIUM_DRIVER");
}

TEST(GlContext, TheEnvironmentChoosesTheLibrary) {
  unsetenv("HACKLE_GL");
  EXPECT_EQ(chosen_gl_library(), GlLibrary::osmesa);
  setenv("HACKLE_GL", "egl", 1);
  EXPECT_EQ(chosen_gl_library(), GlLibrary::egl);
  setenv("HACKLE_GL", "elg", 1);
  try {
    chosen_gl_library();
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'egl'"));
  }
  unsetenv("HACKLE_GL");
}

}  // namespace
}  // namespace hackle
