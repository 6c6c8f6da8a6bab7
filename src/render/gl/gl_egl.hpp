// SPDX-License-Identifier: MIT
// OpenGL through EGL without a surface, drawing into its own framebuffer. The library is opened on
// first use, so that Hackle also runs on systems without it.
#pragma once

#include <memory>

#include "render/gl/gl_back_end.hpp"

namespace hackle {

// Makes a context for pictures of this size, in px. Returns null if this system has no EGL that
// works without a display.
std::unique_ptr<GlBackEnd> make_egl(int width, int height);

}  // namespace hackle
