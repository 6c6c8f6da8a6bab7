// SPDX-License-Identifier: MIT
// An off-screen OpenGL 3.3 core context that draws into memory. What is outside this pair does not
// know which library draws.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "base/image.hpp"
#include "render/gl_functions.hpp"

namespace hackle {

// OSMesa, and EGL without a surface, for systems whose Mesa has no OSMesa any more.
enum class GlLibrary { osmesa, egl };
inline constexpr std::array<std::string_view, 2> gl_library_names{"osmesa", "egl"};

// What the environment variable HACKLE_GL says, or OSMesa. Throws Error (refused) for a name that
// there is not.
GlLibrary chosen_gl_library();

class GlContext {
 public:
  // A context for pictures of this size, current on the calling thread, which must be the only one
  // to use it. Throws Error (run_failed) when the library gives none.
  GlContext(int width, int height, GlLibrary library = chosen_gl_library());
  ~GlContext();

  // Sends the GL calls of this thread to this context, as the constructor does.
  void make_current();

  const GlFunctions& functions() const;

  // The framebuffer that finish() reads, bound at first.
  GLuint target() const;

  // The pixels of the target after everything drawn so far, the top row first.
  const Image& finish();

  // What draws, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
  std::string renderer() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
