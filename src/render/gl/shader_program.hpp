// SPDX-License-Identifier: MIT
// A compiled and linked vertex and fragment shader from shaders/.
#pragma once

#include <string>

#include "render/gl/gl_functions.hpp"

namespace hackle {

class ShaderProgram {
 public:
  // Loads NAME.vert and NAME.frag of the folder shaders/. Throws Error (files) if one is missing,
  // Error (run_failed) with file and line if one does not compile.
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

// Compiles one shader; `file` is its name in messages. Throws Error (run_failed).
GLuint compile_shader(const GlFunctions& gl, GLenum kind, const std::string& file,
                      const std::string& text);

}  // namespace hackle
