// SPDX-License-Identifier: MIT
// What picture the options of a user ask for.
#pragma once

#include <string>

#include "output/run.hpp"
#include "render/plate_painter.hpp"

namespace hackle {

// Throws Error (refused) with every problem of the options; `output` names who asks.
void check(const char* output, const PictureOptions& options);

PictureStyle style_of(const PictureOptions& options, const Simulation& simulation);

// The field by its name, one of field_names; nan where there is no material.
Field field_of(const std::string& name, const Simulation& simulation);

}  // namespace hackle
