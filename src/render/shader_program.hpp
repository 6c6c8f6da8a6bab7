// SPDX-License-Identifier: MIT
// A vertex and a fragment shader from shaders/, compiled and linked.
#pragma once

#include <string>

#include "render/gl_functions.hpp"

namespace hackle {

class ShaderProgram {
 public:
  // NAME.vert and NAME.frag of the folder shaders/. Throws Error (files) when one is missing, Error
  // (run_failed) with file and line when one does not compile.
  ShaderProgram(const GlFunctions& gl, const std::string& name);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  void use() const;
  GLint uniform(const char* name) const;

 private:
  const GlFunctions& gl_;
  GLuint program_;
};

// Compiles one shader; `file` is what a message calls it. Throws Error (run_failed).
GLuint compile_shader(const GlFunctions& gl, GLenum kind, const std::string& file,
                      const std::string& text);

}  // namespace hackle
