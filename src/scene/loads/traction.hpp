// SPDX-License-Identifier: MIT
#pragma once

#include "scene/amplitude.hpp"
#include "scene/field_of_place.hpp"
#include "scene/loads/edge.hpp"

namespace hackle {

// A stress vector on an edge, positive along x and y. It acts as a body force on the outermost
// nodes, or on all nodes down to `depth`; the resultant is the same.
struct Traction {
  Edge edge = Edge::top;
  VectorField stress;  // Pa
  double depth = 0.0;  // m; 0 means one spacing
  Amplitude amplitude;
};

template <>
inline constexpr auto description_of<Traction> = describe_noun(
    "traction", "traction",
    member("edge", &Traction::edge,
           {.required = true, .sentence = "Edge it acts on, over its whole length."}),
    member("stress", &Traction::stress,
           {.unit = "Pa",
            .required = true,
            .sentence = "Force per area of the edge; positive right and up."}),
    member("depth", &Traction::depth,
           {.unit = "m",
            .range = above(0.0),
            .fallback = "one spacing",
            .sentence =
                "Depth of the layer over which the force is spread; the resultant is the same."}),
    member("time", &Traction::amplitude, about_amplitude));

// Returns whether a new load replaces the old one; likewise in the other headers of this folder.
inline bool same_place(const Traction& one, const Traction& other) {
  return one.edge == other.edge;
}

}  // namespace hackle
