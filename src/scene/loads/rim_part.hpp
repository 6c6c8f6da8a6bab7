// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "base/described.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// The part of a rim on which a load acts: seen from the middle of the shape between two angles, rad
// from x anticlockwise; nothing means all of it.
using RimPart = std::optional<Vec2>;

// The member that loads on rims have for it. Several rims of one name have a middle each.
inline constexpr About about_rim_part{
    .unit = "rad",
    .range = between(-100.0, 100.0),
    .fallback = "all around",
    .nothing = "all around",
    .sentence =
        "Arc on which it acts, from one angle to another as seen from the middle of the "
        "rim, from x anticlockwise; {80*deg, 100*deg} is the top."};

}  // namespace hackle
