// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/amplitude.hpp"
#include "scene/field_of_place.hpp"
#include "scene/loads/load_name.hpp"
#include "scene/shape.hpp"

namespace hackle {

// A force per volume on the material of a region.
struct BodyForce {
  Region region;
  VectorField force;  // N/m3
  Amplitude amplitude;
  std::string name;  // "" for none
};

template <>
inline constexpr auto description_of<BodyForce> =
    describe_noun("body_force", "body force", member("region", &BodyForce::region, about_region),
                  member("force", &BodyForce::force,
                         {.unit = "N/m3",
                          .required = true,
                          .sentence = "Force per volume; positive right and up."}),
                  member("time", &BodyForce::amplitude, about_amplitude),
                  member("name", &BodyForce::name, about_load_name));

inline bool same_place(const BodyForce& one, const BodyForce& other) {
  return one.region == other.region;
}

}  // namespace hackle
