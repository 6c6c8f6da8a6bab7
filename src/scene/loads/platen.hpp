// SPDX-License-Identifier: MIT
#pragma once

#include "scene/loads/guided.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// A rigid box in the plane of the plate, which a machine leads, presses or holds, and which pushes
// the nodes it meets: a platen of a compression test.
struct Platen {
  Vec2 from{0, 0};  // m, opposite corners before it moves
  Vec2 to{0, 0};
  Guided guided;
};

template <>
inline constexpr auto description_of<Platen> = describe_noun(
    "platen", "platen",
    member("from", &Platen::from,
           {.unit = "m",
            .required = true,
            .sentence = "A corner before it moves; the box is outside the plate as it is drawn, or "
                        "in a hole."}),
    member("to", &Platen::to, {.unit = "m", .required = true, .sentence = "The opposite corner."}),
    member("", &Platen::guided));

template <>
inline constexpr Introduction introduction_of<Platen>{
    "Presses a rigid box that is led, or held, against the plate, as in a compression test.",
    "p:platen { from = {0, 40*mm}, to = {100*mm, 50*mm}, velocity = {0, -2} }\n"
    "p:platen { from = {0, -10*mm}, to = {100*mm, 0}, force = {0, 1e6} }",
    "s:platen { from = {0, 40*mm}, to = {100*mm, 50*mm}, velocity = {0, -2} }",
    "roller impactor move"};

// See those of a roller.
inline double breadth_of(const Platen& platen) {
  return (platen.to - platen.from).cwiseAbs().maxCoeff();
}
inline double area_of(const Platen& platen) {
  return (platen.to - platen.from).cwiseAbs().prod();
}

inline bool same_place(const Platen& one, const Platen& other) {
  return one.from == other.from && one.to == other.to;
}

}  // namespace hackle
