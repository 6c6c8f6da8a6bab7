// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/amplitude.hpp"
#include "scene/field_of_place.hpp"
#include "scene/loads/load_name.hpp"
#include "scene/shape.hpp"

namespace hackle {

// A change of temperature, which stretches every free bond by alphaT times the change.
struct ThermalLoad {
  Region region;
  ScalarField change;  // K
  Amplitude amplitude;
  std::string name;  // "" for none
};

template <>
inline constexpr auto description_of<ThermalLoad> = describe_noun(
    "temperature", "temperature change", member("region", &ThermalLoad::region, about_region),
    member("change", &ThermalLoad::change,
           {.unit = "K", .required = true, .sentence = "Change from the stress-free temperature."}),
    member("time", &ThermalLoad::amplitude, about_amplitude),
    member("name", &ThermalLoad::name, about_load_name));

inline bool same_place(const ThermalLoad& one, const ThermalLoad& other) {
  return one.region == other.region;
}

}  // namespace hackle
