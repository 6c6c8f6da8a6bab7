// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/amplitude.hpp"
#include "scene/field_of_place.hpp"
#include "scene/loads/load_name.hpp"
#include "scene/shape.hpp"

namespace hackle {

// Prescribes the motion of nodes along x, y or both; value 0 clamps them.
struct Support {
  enum class Kind { displacement, velocity };
  Region region;
  Kind kind = Kind::displacement;
  VectorField value;  // m or m/s, at amplitude 1
  bool along_x = true;
  bool along_y = true;
  Amplitude amplitude;
  std::string name;  // "" for none
};

template <>
inline constexpr auto description_of<Support> = describe_noun(
    "support", "support", member("region", &Support::region, about_region),
    kind_member(&Support::kind, &Support::value,
                std::to_array<std::string_view>({"displacement", "velocity"}),
                std::to_array<About>(
                    {{.unit = "m", .alternative = true, .sentence = "Prescribed displacement."},
                     {.unit = "m/s",
                      .alternative = true,
                      .sentence = "Prescribed velocity, instead of a displacement."}})),
    member("along_x", &Support::along_x), member("along_y", &Support::along_y),
    member("time", &Support::amplitude, about_amplitude),
    member("name", &Support::name, about_load_name));

inline bool same_place(const Support& one, const Support& other) {
  return one.region == other.region && one.along_x == other.along_x && one.along_y == other.along_y;
}

}  // namespace hackle
