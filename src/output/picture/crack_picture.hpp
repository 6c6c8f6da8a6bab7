// SPDX-License-Identifier: MIT
// The graph of cracks as pictures show it.
#pragma once

#include "measure/crack_graph.hpp"
#include "render/overlay/crack_drawing.hpp"

namespace hackle {

// All paths, and the tips that have not arrived or joined, with the speed of those that run.
CrackDrawing crack_drawing(const CrackGraph& graph);
// Of a state of which nothing is known but what is broken: without speeds.
CrackDrawing crack_drawing(const View& view);

}  // namespace hackle
