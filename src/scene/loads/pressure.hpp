// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/amplitude.hpp"
#include "scene/loads/load_name.hpp"
#include "scene/loads/rim_part.hpp"

namespace hackle {

// A pressure on the rim of a hole, notch or outline, or on both faces of a crack that the plate was
// born with, positive into the material. Faces that break later are not loaded.
struct Pressure {
  std::string rim;        // name of the cut-out, outline or crack
  double pressure = 0.0;  // Pa
  Amplitude amplitude;
  RimPart angles;
  std::string name;  // "" for none
};

template <>
inline constexpr auto description_of<Pressure> = describe_noun(
    "pressure", "pressure",
    member(
        "rim", &Pressure::rim,
        {.required = true,
         .sentence = "Name of a hole, a notch, an outline or a crack; a crack is pushed open, but "
                     "not where it grows."}),
    member("pressure", &Pressure::pressure,
           {.unit = "Pa", .required = true, .sentence = "Pressure, positive into the material."}),
    member("time", &Pressure::amplitude, about_amplitude),
    member("angles", &Pressure::angles, about_rim_part),
    member("name", &Pressure::name, about_load_name));

inline bool same_place(const Pressure& one, const Pressure& other) {
  return one.rim == other.rim && one.angles == other.angles;
}

}  // namespace hackle
