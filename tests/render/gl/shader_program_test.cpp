// SPDX-License-Identifier: MIT
#include "render/gl/shader_program.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "render/gl/gl_context.hpp"

namespace hackle {
namespace {

TEST(ShaderProgram, TheColourShadersHaveTheirUniforms) {
  const GlContext context(4, 4);
  const GlFunctions& gl = context.functions();
  const ShaderProgram program(gl, "colours");
  for (const char* name : {"values", "damage", "colour_map", "range", "background"})
    EXPECT_GE(program.uniform(name), 0) << name;
}

TEST(ShaderProgram, AnErrorNamesFileAndLine) {
  const GlContext context(4, 4);
  const GlFunctions& gl = context.functions();
  try {
    compile_shader(gl, GL_FRAGMENT_SHADER, "shaders/bad.frag",
                   "#version 330 core\nvoid main() {\n  nonsense;\n}\n");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("shaders/bad.frag:3"));
  }
}

}  // namespace
}  // namespace hackle
