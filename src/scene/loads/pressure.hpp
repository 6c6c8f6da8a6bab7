// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/amplitude.hpp"

namespace hackle {

// A pressure on the rim of a hole or notch, positive into the material.
struct Pressure {
  std::string rim;        // name of the cut-out
  double pressure = 0.0;  // Pa
  Amplitude amplitude;
};

template <>
inline constexpr auto description_of<Pressure> = describe_noun(
    "pressure", "pressure",
    member("rim", &Pressure::rim, {.required = true, .sentence = "Name of a hole or notch."}),
    member("pressure", &Pressure::pressure,
           {.unit = "Pa", .required = true, .sentence = "Pressure, positive into the material."}),
    member("time", &Pressure::amplitude, about_amplitude));

inline bool same_place(const Pressure& one, const Pressure& other) {
  return one.rim == other.rim;
}

}  // namespace hackle
