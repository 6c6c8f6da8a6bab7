// SPDX-License-Identifier: MIT
#pragma once

#include "scene/course.hpp"
#include "scene/field_of_place.hpp"
#include "scene/shape.hpp"

namespace hackle {

// A change of temperature, which stretches every free bond by alphaT times it.
struct Heating {
  Region region;
  ScalarField change;  // K
  Course course;
};

template <>
inline constexpr auto description_of<Heating> = describe_noun(
    "temperature", "temperature change", member("region", &Heating::region, about_region),
    member("change", &Heating::change,
           {.unit = "K",
            .required = true,
            .sentence = "From the temperature at which it is free of stress."}),
    member("time", &Heating::course, about_course));

inline bool same_place(const Heating& one, const Heating& other) {
  return one.region == other.region;
}

}  // namespace hackle
