// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "scene/amplitude.hpp"
#include "scene/field_of_place.hpp"
#include "scene/loads/edge.hpp"
#include "scene/loads/load_name.hpp"
#include "scene/loads/rim_part.hpp"

namespace hackle {

// A stress vector on an edge, or on the rim of a hole, notch or outline, positive along x and y. It
// acts as a body force on the outermost nodes, or on all nodes of an edge down to `depth`; the
// resultant is the same.
struct Traction {
  std::optional<Edge> edge;
  VectorField stress;  // Pa
  double depth = 0.0;  // m; 0 means one spacing
  Amplitude amplitude;
  std::string rim;  // name of the cut-out or outline; "" with an edge
  RimPart angles;
  std::string name;  // "" for none
};

template <>
inline constexpr auto description_of<Traction> = describe_noun(
    "traction", "traction",
    member("edge", &Traction::edge,
           {.alternative = true, .sentence = "Edge it acts on, over its whole length."}),
    member("stress", &Traction::stress,
           {.unit = "Pa",
            .required = true,
            .sentence = "Force per area of the edge or rim; positive right and up."}),
    member("depth", &Traction::depth,
           {.unit = "m",
            .range = above(0.0),
            .fallback = "one spacing",
            .sentence = "Depth of the layer at an edge over which the force is spread; the "
                        "resultant is the same."}),
    member("time", &Traction::amplitude, about_amplitude),
    member("rim", &Traction::rim,
           {.alternative = true,
            .sentence = "Name of a hole, a notch or an outline whose rim it acts on, instead of an "
                        "edge."}),
    member("angles", &Traction::angles, about_rim_part),
    member("name", &Traction::name, about_load_name));

// Returns whether a new load replaces the old one; likewise in the other headers of this folder.
inline bool same_place(const Traction& one, const Traction& other) {
  return one.edge == other.edge && one.rim == other.rim && one.angles == other.angles;
}

}  // namespace hackle
