// SPDX-License-Identifier: MIT
// A simulation as a terminal can show it.
#pragma once

#include <string>

#include "console/language/preview.hpp"
#include "output/run.hpp"

namespace hackle {

// "damage at 22.5 us, 1 234 bonds broken, 20 mm wide"
std::string caption(const Simulation& simulation, const PictureOptions& options);

// The picture with the caption beneath, for write_picture. The options have been checked.
std::string picture_text(const Simulation& simulation, const PictureOptions& options,
                         const Terminal& terminal);

}  // namespace hackle
