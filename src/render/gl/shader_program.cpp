// SPDX-License-Identifier: MIT
#include "render/gl/shader_program.hpp"

#include <array>
#include <regex>

#include "base/error.hpp"
#include "base/files.hpp"

namespace hackle {
namespace {

// Turns Mesa's "0:12(3): error: ..." into the usual "colours.frag:12: error: ...".
std::string with_file_name(const std::string& log, const std::string& file) {
  static const std::regex place(R"((^|\n)0:(\d+)\(\d+\))");
  return std::regex_replace(log, place, "$1" + file + ":$2");
}

GLuint compile_file(const GlFunctions& gl, GLenum kind, const std::string& name) {
  const std::string file = "shaders/" + name;
  return compile_shader(gl, kind, file, read_text(data_file(file)));
}

}  // namespace

GLuint compile_shader(const GlFunctions& gl, GLenum kind, const std::string& file,
                      const std::string& text) {
  const GLuint shader = gl.CreateShader(kind);
  const char* source = text.c_str();
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  std::array<char, 4096> log{};
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteShader(shader);
  throw Error(ErrorKind::run_failed,
              "a shader does not compile: " + with_file_name(log.data(), file));
}

ShaderProgram::ShaderProgram(const GlFunctions& gl, const std::string& name)
    : gl_(gl), program_(gl.CreateProgram()) {
  const GLuint vertex = compile_file(gl, GL_VERTEX_SHADER, name + ".vert");
  const GLuint fragment = compile_file(gl, GL_FRAGMENT_SHADER, name + ".frag");
  gl.AttachShader(program_, vertex);
  gl.AttachShader(program_, fragment);
  gl.LinkProgram(program_);
  gl.DeleteShader(vertex);
  gl.DeleteShader(fragment);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program_, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return;
  std::array<char, 4096> log{};
  gl.GetProgramInfoLog(program_, static_cast<GLsizei>(log.size()), nullptr, log.data());
  throw Error(ErrorKind::run_failed, "the shaders '" + name + "' do not link: " + log.data());
}

ShaderProgram::~ShaderProgram() {
  gl_.DeleteProgram(program_);
}
void ShaderProgram::use() const {
  gl_.UseProgram(program_);
}
GLint ShaderProgram::uniform(const char* name) const {
  return gl_.GetUniformLocation(program_, name);
}

}  // namespace hackle
