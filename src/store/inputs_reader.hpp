// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "lattice/numerics.hpp"
#include "scene/plate.hpp"

namespace hackle {

// What a run was made from. Functions of place and time are those of a script, which are not in the
// text: they are there, and throw Error (files) when they are asked.
struct Inputs {
  Plate plate;
  Numerics numerics;  // with the step that was taken
};

// The inverse of inputs_of(), to the last bit. Throws Error (files) for a text it did not write,
// without quoting it, and for one of more values or cells of pictures than a scene has; the values
// themselves are not checked. Throws Error (interrupted) on Ctrl-C.
Inputs read_inputs(const std::string& text);

}  // namespace hackle
