// SPDX-License-Identifier: MIT
// What part of the plate a picture looks at, and from where.
#pragma once

#include "base/error.hpp"
#include "output/picture/picture.hpp"
#include "render/camera.hpp"
#include "solver/simulation.hpp"

namespace hackle {

// Adds every problem of the options on that lattice; `output` names who asks.
void check_view(const char* output, const PictureOptions& options, const Grid& grid,
                Problems& problems);

// How many times as large as they are displacements are shown; 0 for the plate at rest. What suits
// the plate is a neat number: as the bonds of its material are about to break, its edges have moved
// by about 1 % of its shorter side.
double magnification_of(const PictureOptions& options, const Simulation& simulation);

// The cells that the options look at: a zoom as it is given, the whole plate otherwise, with room
// for its displacements.
Window window_of(const PictureOptions& options, const Simulation& simulation);

// The window moved to where the foremost damage is, displaced as it is shown; as it was when there
// is none.
Window followed(Window window, const PictureOptions& options, const Simulation& simulation);

}  // namespace hackle
