// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "lattice/numerics.hpp"
#include "scene/plate.hpp"

namespace hackle {

// The inputs of a run. Functions of place and time belong to a script and are not in the text: they
// exist here, but throw Error (files) when evaluated.
struct Inputs {
  Plate plate;
  Numerics numerics;  // with the step of the run
};

// The inverse of inputs_of(), to the last bit. Throws Error (files) for a text that inputs_of() did
// not write, without quoting it, and for more values or picture cells than a scene can have; the
// values themselves are not checked. Throws Error (interrupted) on Ctrl-C.
Inputs read_inputs(const std::string& text);

}  // namespace hackle
