// SPDX-License-Identifier: MIT
// OpenGL by EGL without a surface, which draws into a framebuffer of its own. The library is opened
// when it is asked for: a system without it runs Hackle all the same.
#pragma once

#include <memory>

#include "render/gl_back_end.hpp"

namespace hackle {

// For pictures of so many px. Null when this system has no EGL that works without a display.
std::unique_ptr<GlBackEnd> make_egl(int width, int height);

}  // namespace hackle
