// SPDX-License-Identifier: MIT
// Fields for files, by their names: those of pictures (scalar.hpp), and vectors.
#pragma once

#include <string_view>
#include <vector>

#include "measure/field.hpp"

namespace hackle {

// Returns "displacement" and "velocity", which are vectors here, and scalar_names.
std::vector<std::string_view> field_names();

// Throws Error (refused), with the nearest name, for an unknown name, and where the plate does not
// have the field: see check_fringes().
Field field_by_name(const View& view, std::string_view name);

// Returns damage, displacement and velocity, and temperature where something is heated.
std::vector<std::string_view> standard_fields(const View& view);

}  // namespace hackle
