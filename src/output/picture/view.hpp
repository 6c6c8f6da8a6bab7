// SPDX-License-Identifier: MIT
// The part of the plate that a picture shows, and its orientation.
#pragma once

#include "base/error.hpp"
#include "output/picture/picture.hpp"
#include "render/camera.hpp"
#include "solver/view.hpp"

namespace hackle {

// Adds every problem of the options on that lattice; `output` names the caller.
void check_view(const char* output, const PictureOptions& options, const Grid& grid,
                Problems& problems);

// Returns the factor on displacements; 0 shows the undeformed plate. The default is a round number:
// when bonds of the plate's material are about to break, its edges appear displaced by about 1 % of
// its shorter side.
double magnification_of(const PictureOptions& options, const View& view);

// Returns the visible cells: a given zoom, or else the whole plate with room for its displacements:
// those that it has now, and those that it is likely to get.
Window window_of(const PictureOptions& options, const View& view);

// Returns the window moved to the foremost damage, displaced as shown; unchanged if there is none.
Window followed(Window window, const PictureOptions& options, const View& view);

}  // namespace hackle
