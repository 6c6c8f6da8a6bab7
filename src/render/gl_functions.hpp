// SPDX-License-Identifier: MIT
// The OpenGL functions that Hackle calls, loaded through the context.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

namespace hackle {

// type, name without "gl"
#define HACKLE_GL_FUNCTIONS(X)                       \
  X(PFNGLACTIVETEXTUREPROC, ActiveTexture)           \
  X(PFNGLATTACHSHADERPROC, AttachShader)             \
  X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)       \
  X(PFNGLCOMPILESHADERPROC, CompileShader)           \
  X(PFNGLCREATEPROGRAMPROC, CreateProgram)           \
  X(PFNGLCREATESHADERPROC, CreateShader)             \
  X(PFNGLDELETEPROGRAMPROC, DeleteProgram)           \
  X(PFNGLDELETESHADERPROC, DeleteShader)             \
  X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays) \
  X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)       \
  X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)   \
  X(PFNGLGETPROGRAMIVPROC, GetProgramiv)             \
  X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)     \
  X(PFNGLGETSHADERIVPROC, GetShaderiv)               \
  X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation) \
  X(PFNGLLINKPROGRAMPROC, LinkProgram)               \
  X(PFNGLSHADERSOURCEPROC, ShaderSource)             \
  X(PFNGLUNIFORM1IPROC, Uniform1i)                   \
  X(PFNGLUNIFORM2FPROC, Uniform2f)                   \
  X(PFNGLUNIFORM4FPROC, Uniform4f)                   \
  X(PFNGLUSEPROGRAMPROC, UseProgram)

// gl.CreateShader(...) is glCreateShader(...). Functions of OpenGL 1.1 (glClear, glTexImage2D, ...)
// are called by their own names.
struct GlFunctions {
#define HACKLE_DECLARE(type, name) type name = nullptr;
  HACKLE_GL_FUNCTIONS(HACKLE_DECLARE)
#undef HACKLE_DECLARE
};

// Needs a current context.
GlFunctions load_gl_functions();

}  // namespace hackle
