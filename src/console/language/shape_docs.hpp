// SPDX-License-Identifier: MIT
// The options of the functions in shape_binding.cpp.
#pragma once

#include <array>
#include <numbers>
#include <string_view>

#include "console/language/noun_options.hpp"
#include "console/language/region_options.hpp"
#include "console/language/shape_options.hpp"
#include "scene/notch.hpp"

namespace hackle {

inline constexpr std::array<std::string_view, 2> remove_names{"dark", "light"};

inline constexpr auto born_options = without("points", options_of<Crack>);
inline constexpr auto name_options = options_of<Cutout>;

inline constexpr auto hole_options = joined(shape_options, name_options);

inline constexpr auto keep_options =
    joined(joined(shape_options,
                  std::array{Option{
                      .name = "any",
                      .type = OptionType::areas,
                      .read = read_areas,
                      .alternative = true,
                      .sentence = "Several areas; everything that any of them covers is kept."}}),
           options_of<Outline>);

inline constexpr FunctionDoc keep_doc{
    .name = "keep",
    .owner = "p",
    .sentence =
        "Keeps the part of the plate inside an area and removes the rest; several calls keep the "
        "part common to all.",
    .options = keep_options,
    .example = "p:keep { centre = {50*mm, 20*mm}, radius = 20*mm }"};

inline constexpr FunctionDoc hole_doc{
    .name = "hole",
    .owner = "p",
    .sentence = "Cuts out a circle, a ring, an ellipse, a polygon, a star or a slot.",
    .options = hole_options,
    .example = "p:hole { centre = {70*mm, 20*mm}, radius = 5*mm, name = \"bore\" }"};

inline constexpr std::array notch_options{
    Option{.name = "at",
           .type = OptionType::point,
           .unit = "m",
           .required = true,
           .sentence = "Beginning of the notch: a point on an edge."},
    Option{.name = "depth",
           .unit = "m",
           .range = above(0.0),
           .required = true,
           .sentence = "Depth from there to the tip."},
    Option{.name = "width",
           .unit = "m",
           .range = above(0.0),
           .required = true,
           .sentence = "Width across the notch; of a V at its beginning."},
    Option{.name = "shape",
           .type = OptionType::choice,
           .fallback = "slot",
           .choices = notch_names,
           .sentence = "Shape of its end: flat, a sharp tip, or round."},
    Option{.name = "angle",
           .unit = "rad",
           .range = between(-1.4, 1.4),
           .fallback = "0",
           .sentence = "Direction, anticlockwise from the perpendicular of the edge."},
    name_options[0],
};

inline constexpr FunctionDoc notch_doc{
    .name = "notch",
    .owner = "p",
    .sentence = "Removes material from an edge inwards.",
    .options = notch_options,
    .example = "p:notch { at = {0, 10*mm}, depth = 8*mm, width = 2*mm, shape = \"v\" }"};

inline constexpr std::array straight_crack_options{
    Option{.name = "from",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "One end of a straight crack, on the plate."},
    Option{.name = "to",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Other end of a straight crack."},
};

inline constexpr std::array arc_options{
    Option{.name = "centre",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Centre of a crack along an arc."},
    Option{.name = "radius",
           .unit = "m",
           .range = above(0.0),
           .alternative = true,
           .sentence = "Radius of the arc."},
    Option{.name = "angles",
           .type = OptionType::pair,
           .unit = "rad",
           .range = between(-100.0, 100.0),
           .alternative = true,
           .sentence = "First and last angle of the arc, from x anticlockwise; at most one turn."},
};

inline constexpr auto crack_options = joined(joined(straight_crack_options, options_of<Crack>),
                                             joined(point_unit_options, arc_options));

inline constexpr FunctionDoc crack_doc{
    .name = "crack",
    .owner = "p",
    .sentence = "Cuts every bond that meets a straight crack, a polyline or an arc.",
    .options = crack_options,
    .example = "p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }"};

inline constexpr std::array random_cracks_options{
    Option{.name = "count",
           .type = OptionType::integer,
           .range = between(1, 100000),
           .required = true,
           .sentence = "Number of cracks."},
    Option{.name = "length",
           .type = OptionType::pair,
           .unit = "m",
           .range = above(0.0),
           .required = true,
           .sentence = "Lengths, uniform between {minimum, maximum}."},
    Option{.name = "angle",
           .type = OptionType::pair,
           .unit = "rad",
           .range = between(-100.0, 100.0),
           .fallback = "{0, 180*deg}",
           .sentence = "Directions from x anticlockwise, uniform between {minimum, maximum}."},
    Option{.name = "seed",
           .type = OptionType::integer,
           .fallback = "1",
           .sentence = "Seed; another one gives other cracks."},
    Option{.name = "from",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Lower left corner of the area they lie in; default: the plate."},
    Option{.name = "to",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Upper right corner of the area."},
    born_options[0],
};

inline constexpr FunctionDoc random_cracks_doc{
    .name = "random_cracks",
    .owner = "p",
    .sentence =
        "Adds straight cracks at random places, the same for the same seed on every machine.",
    .options = random_cracks_options,
    .example = "p:random_cracks { count = 10, length = {2*mm, 6*mm}, seed = 3 }"};

inline constexpr auto inclusion_options = joined(options_of<Inclusion>, shape_options);

inline constexpr FunctionDoc inclusion_doc{
    .name = "inclusion",
    .owner = "p",
    .sentence = "Fills a circle, an ellipse, a polygon or a slot with another material.",
    .options = inclusion_options,
    .example = "p:inclusion { material = \"duran50\", centre = {30*mm, 20*mm}, radius = 4*mm }"};

inline constexpr std::array mask_options{
    Option{.name = "file",
           .type = OptionType::text,
           .required = true,
           .positional = true,
           .sentence = "PNG beside the script, in the output folder or named on the command line."},
    Option{.name = "remove",
           .type = OptionType::choice,
           .fallback = "dark",
           .choices = remove_names,
           .sentence = "Pixels that are cut out; transparent pixels count as lying on white."},
    Option{.name = "threshold",
           .range = between(0.0, 1.0),
           .fallback = "0.5",
           .sentence = "Pixels below it are dark; black is 0, white is 1."},
    Option{.name = "from",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Lower left corner of the picture on the plate; default: the whole plate."},
    Option{.name = "to",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Upper right corner of the picture on the plate."},
    Option{.name = "material",
           .type = OptionType::material,
           .read = read_material,
           .alternative = true,
           .sentence = "Fills the pixels with this material instead of cutting them out."},
    name_options[0],
};

inline constexpr FunctionDoc mask_doc{
    .name = "mask",
    .owner = "p",
    .sentence = "Lays a picture over the plate and cuts out its dark or light pixels.",
    .options = mask_options,
    .example =
        "-- p:mask { \"grains.png\", remove = \"dark\", from = {0, 0}, to = {20*mm, 20*mm} }"};

}  // namespace hackle
