// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "lattice/numerics.hpp"
#include "scene/plate.hpp"

namespace hackle {

// What determines the lattice of a run and its pictures: the plate without loads, starts and
// contact, and the numerics with the step that was taken, in f64 and not fused.
struct Inputs {
  Plate plate;
  Numerics numerics;
};

// The inverse of inputs_of(), to the last bit. Throws Error (files) for a text it did not write;
// the values themselves are not checked.
Inputs read_inputs(const std::string& text);

}  // namespace hackle
