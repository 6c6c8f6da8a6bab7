// SPDX-License-Identifier: MIT
#include "render/shader_program.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "render/gl_context.hpp"

namespace hackle {
namespace {

TEST(ShaderProgram, TheFieldShadersHaveTheirUniforms) {
  const GlContext context(4, 4);
  const GlFunctions gl = load_gl_functions();
  const ShaderProgram program(gl, "field");
  for (const char* name : {"field", "colour_map", "cells", "range", "background"})
    EXPECT_GE(program.uniform(name), 0) << name;
}

TEST(ShaderProgram, AnErrorNamesFileAndLine) {
  const GlContext context(4, 4);
  const GlFunctions gl = load_gl_functions();
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
