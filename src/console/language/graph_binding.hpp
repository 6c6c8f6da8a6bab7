// SPDX-License-Identifier: MIT
// s:tips, s:graph and r:graph: the cracks as a graph.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> graph_methods();           // of a simulation
std::span<const Function> recorded_graph_methods();  // of a recording

}  // namespace hackle
