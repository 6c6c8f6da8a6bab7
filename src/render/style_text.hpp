// SPDX-License-Identifier: MIT
// What a style has written around the plate, and in which colours.
#pragma once

#include <vector>

#include "render/colour_map.hpp"
#include "render/overlay/overlay_text.hpp"
#include "render/picture_style.hpp"

namespace hackle {

OverlayText overlay_text_of(const PictureStyle& style);

// Throw what load_colour_map throws. The maps are those of the bars, one for each field.
ColourMap colour_map_of(const FieldStyle& field);
std::vector<ColourMap> colour_maps_of(const PictureStyle& style);

}  // namespace hackle
