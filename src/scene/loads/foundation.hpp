// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/loads/load_name.hpp"
#include "scene/shape.hpp"

namespace hackle {

// An elastic bed: pulls the material of a region back to where it was described, by a force per
// volume of `stiffness` times its displacement. Of thin plates glued to a bed of shear modulus G
// and thickness b on one side, stiffness is G/(b times the thickness of the plate).
struct Foundation {
  enum class Along { both, x, y };
  Region region;
  double stiffness = 0.0;  // N/m4: N/m3 per m
  Along along = Along::both;
  std::string name;  // "" for none

  double along_x() const { return along == Along::y ? 0.0 : stiffness; }
  double along_y() const { return along == Along::x ? 0.0 : stiffness; }
};

template <>
inline constexpr auto enum_names<Foundation::Along> = std::to_array<std::string_view>({"both", "x",
                                                                                       "y"});

template <>
inline constexpr auto description_of<Foundation> = describe_noun(
    "foundation", "foundation", member("region", &Foundation::region, about_region),
    member("stiffness", &Foundation::stiffness,
           {.unit = "N/m4",
            .range = above(0.0),
            .required = true,
            .sentence = "Force per volume and displacement, N/m3 per m."}),
    member("along", &Foundation::along,
           {.fallback = "both", .sentence = "Along which axis it pulls; the other stays free."}),
    member("name", &Foundation::name, about_load_name));

template <>
inline constexpr Introduction introduction_of<Foundation>{
    "Beds an area, or the plate, on springs that pull it back to where it was.",
    "p:foundation { stiffness = 1e13 }", "s:foundation { stiffness = 1e13, along = \"y\" }",
    "clamp move body_force damping"};

inline bool same_place(const Foundation& one, const Foundation& other) {
  return one.region == other.region && one.along == other.along;
}

// By which it limits the time step, N/m4: see spring_stiffness(const Loads&).
inline double spring_stiffness(const Foundation& foundation) {
  return foundation.stiffness;
}

}  // namespace hackle
