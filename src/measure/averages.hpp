// SPDX-License-Identifier: MIT
// Fields without their shortest waves: means over a horizon.
#pragma once

#include <vector>

#include "measure/bond_field.hpp"
#include "solver/view.hpp"

namespace hackle {

// Returns, by Grid::index, the mean over each node and all to which intact bonds join it: over a
// horizon, but not across a crack. A node without bonds keeps its value.
std::vector<float> averaged(const View& view, const std::vector<float>& values);
std::vector<Stress> averaged(const View& view, const std::vector<Stress>& values);

}  // namespace hackle
