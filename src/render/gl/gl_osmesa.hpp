// SPDX-License-Identifier: MIT
// OpenGL through OSMesa, which draws straight into the pixels of an image.
#pragma once

#include <memory>

#include "render/gl/gl_back_end.hpp"

namespace hackle {

// The image must outlive it.
std::unique_ptr<GlBackEnd> make_osmesa(Image& image);

}  // namespace hackle
