// SPDX-License-Identifier: MIT
// An off-screen OpenGL 3.3 core context that draws into memory. Code outside this pair does not
// know which library draws.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "base/image.hpp"
#include "render/gl/gl_functions.hpp"

namespace hackle {

// OSMesa, or EGL without a surface for systems whose Mesa lacks OSMesa.
enum class GlLibrary { osmesa, egl };
inline constexpr std::array<std::string_view, 2> gl_library_names{"osmesa", "egl"};

// Returns the library named by the environment variable HACKLE_GL, or OSMesa. Throws Error
// (refused) for an unknown name.
GlLibrary chosen_gl_library();

class GlContext {
 public:
  // Makes a context for pictures of this size, current on the calling thread, which must be the
  // only one to use it. Throws Error (run_failed) if the library cannot make one.
  GlContext(int width, int height, GlLibrary library = chosen_gl_library());
  ~GlContext();

  // Directs the GL calls of this thread to this context, as the constructor does.
  void make_current();

  const GlFunctions& functions() const;

  // Returns the framebuffer that finish() reads; it is bound initially.
  GLuint target() const;

  // Finishes all drawing and returns the pixels of the target, the top row first.
  const Image& finish();

  // Returns the name of the renderer, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
  std::string renderer() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
