// SPDX-License-Identifier: MIT
#include "render/gl_functions.hpp"

#include "render/gl_context.hpp"

namespace hackle {

GlFunctions load_gl_functions() {
  GlFunctions gl;
#define HACKLE_LOAD(type, name) gl.name = reinterpret_cast<type>(GlContext::function("gl" #name));
  HACKLE_GL_FUNCTIONS(HACKLE_LOAD)
#undef HACKLE_LOAD
  return gl;
}

}  // namespace hackle
