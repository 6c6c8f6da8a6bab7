// SPDX-License-Identifier: MIT
// What GlContext needs of a library that makes OpenGL contexts.
#pragma once

#include "base/image.hpp"
#include "render/gl_functions.hpp"

namespace hackle {

// A context of OpenGL 3.3; see gl_osmesa.cpp and gl_egl.cpp.
class GlBackEnd {
 public:
  using Function = void (*)();

  virtual ~GlBackEnd() = default;
  // False when it cannot be had.
  virtual bool make_current() = 0;
  virtual Function function(const char* name) const = 0;
  // What the default framebuffer is for others: where a picture is drawn. Called once, current.
  virtual GLuint make_target(const GlFunctions& gl) = 0;
  // The pixels of the target into `image`, the top row first; nothing is being drawn any more.
  virtual void read(const GlFunctions& gl, Image& image) = 0;
};

}  // namespace hackle
