// SPDX-License-Identifier: MIT
// An off-screen OpenGL 3.3 core context that draws into memory. OSMesa today; what is outside this
// pair does not know, so that EGL can take its place.
#pragma once

#include <memory>
#include <string>

#include "base/image.hpp"

namespace hackle {

class GlContext {
 public:
  using Function = void (*)();

  // A context for pictures of this size, current on the calling thread, which must be the only one
  // to use it. Throws Error (run_failed).
  GlContext(int width, int height);
  ~GlContext();

  // Sends the GL calls of this thread to this context, as the constructor does.
  void make_current();

  // The entry point of a GL function. Never null, even for unknown names: check the version
  // instead.
  static Function function(const char* name);

  // The pixels of the default framebuffer after everything drawn so far, top row first.
  const Image& finish();

  // What draws, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
  std::string renderer() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
