// SPDX-License-Identifier: MIT
#pragma once

#include "scene/amplitude.hpp"
#include "scene/loads/guided.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// A rigid box in the plane of the plate, which a machine leads or holds, and which pushes the nodes
// it meets: a platen of a compression test.
struct Platen {
  Vec2 from{0, 0};  // m, opposite corners before it moves
  Vec2 to{0, 0};
  Guide guide = Guide::displacement;
  Vec2 value{0, 0};  // m or m/s, at amplitude 1
  Amplitude amplitude;
  double friction = 0.0;
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
    kind_member(&Platen::guide, &Platen::value, enum_names<Guide>, about_guide),
    member("time", &Platen::amplitude, about_amplitude),
    member("friction", &Platen::friction, about_friction));

template <>
inline constexpr Introduction introduction_of<Platen>{
    "Presses a rigid box that is led, or held, against the plate, as in a compression test.",
    "p:platen { from = {0, 40*mm}, to = {100*mm, 50*mm}, velocity = {0, -2} }",
    "s:platen { from = {0, 40*mm}, to = {100*mm, 50*mm}, velocity = {0, -2} }",
    "roller impactor move"};

inline bool same_place(const Platen& one, const Platen& other) {
  return one.from == other.from && one.to == other.to;
}

}  // namespace hackle
