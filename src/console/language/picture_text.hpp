// SPDX-License-Identifier: MIT
// Renders a simulation as text for a terminal.
#pragma once

#include <string>

#include "console/language/preview.hpp"
#include "output/picture/picture.hpp"
#include "solver/view.hpp"

namespace hackle {

// Returns "damage at 22.5 us, 1 234 bonds broken, 20 mm wide".
std::string caption(const View& view, const PictureOptions& options);

// Returns the picture with its caption below, for write_picture. The options must have been
// checked.
std::string picture_text(const View& view, const PictureOptions& options, const Terminal& terminal);

}  // namespace hackle
