// SPDX-License-Identifier: MIT
// The interface of GlContext to a library that makes OpenGL contexts.
#pragma once

#include "base/image.hpp"
#include "render/gl/gl_functions.hpp"

namespace hackle {

// A context of OpenGL 3.3; see gl_osmesa.cpp and gl_egl.cpp.
class GlBackEnd {
 public:
  using Function = void (*)();

  virtual ~GlBackEnd() = default;
  // Returns false if the context cannot be made current.
  virtual bool make_current() = 0;
  virtual Function function(const char* name) const = 0;
  // Makes the framebuffer in which a picture is drawn, in place of the default framebuffer. Called
  // once, while current.
  virtual GLuint make_target(const GlFunctions& gl) = 0;
  // Reads the pixels of the target into `image`, the top row first; drawing is finished.
  virtual void read(const GlFunctions& gl, Image& image) = 0;
};

}  // namespace hackle
