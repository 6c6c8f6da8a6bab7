// SPDX-License-Identifier: MIT
// The user's options for a picture.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/described.hpp"
#include "measure/scalar.hpp"
#include "render/colour_map.hpp"
#include "render/picture_style.hpp"

namespace hackle {

// The visible part of the plate: a window of the plate's shape, rounded to whole cells of the
// lattice.
struct Zoom {
  Vec2 centre{0, 0};        // m; the window must show some of the plate
  double half_width = 0.0;  // m, from one spacing to ten widths of the plate
};

template <>
inline constexpr auto description_of<Zoom> =
    describe_noun("zoom", "zoom", member("centre", &Zoom::centre, {.unit = "m"}),
                  member("half_width", &Zoom::half_width, {.unit = "m", .range = above(0.0)}));

// The direction of a crack that a picture follows.
enum class Toward { right, left, up, down };
template <>
inline constexpr auto enum_names<Toward> = std::to_array<std::string_view>({"right", "left", "up",
                                                                            "down"});

// Of a colour bar.
enum class Scale { linear, log };
template <>
inline constexpr auto enum_names<Scale> = std::to_array<std::string_view>({"linear", "log"});

// The options of a picture.
struct PictureOptions {
  std::string field = "damage";       // one of scalar_names
  int width = 1280;                   // px, even; the height follows from the plate
  std::optional<double> pixels_a_mm;  // instead of the width
  std::optional<double> paper;        // m, the width on paper, instead
  double dpi = 300.0;                 // px per inch of paper
  std::optional<double> font_size;    // pt, on paper; default: suits the width
  std::optional<Ends> range;          // of the colour bar, SI; default: depends on the field
  std::optional<double> percentile;   // %, instead of a range: it spans this share of the values
  std::optional<Scale> scale;         // default: depends on the field
  std::string colours;                // one of colour_map_names, or "" for the field's own
  std::optional<std::string> second;  // another of scalar_names
  std::optional<Ends> second_range;   // as range
  Arrangement arrangement = Arrangement::below;  // of the second field
  bool cracks = true;                            // cracks are gaps, except in a picture of damage
  bool smooth = false;                           // between nodes
  bool average = false;                          // over a horizon
  double thickness = 5e-3;                       // m, of the plate, for fringes
  std::optional<Zoom> zoom;                      // default: the whole plate
  std::optional<Toward> follow;                  // the zoom follows the foremost damage
  double rotation = 0.0;                         // rad, anticlockwise
  bool deformed = false;                         // displacements are shown,
  std::optional<double> magnification;  // factor on displacements; default: depends on the plate
  bool bonds = false;                   // drawn one by one
  Look look = Look::dark;
  std::optional<Background> background;  // default: that of the look
  OverlayOptions overlay;                // texts and marks around the plate and on it
};

// px, of the width of a picture.
inline constexpr int min_picture_width = 320, max_picture_width = 7680;

inline constexpr auto second_names = or_none(scalar_names);
inline constexpr std::string_view suits_the_field = "depends on the field";
inline constexpr std::string_view suits_the_theme = "that of the theme";

template <>
inline constexpr auto description_of<PictureOptions> = describe_noun(
    "picture", "picture",
    member("width", &PictureOptions::width,
           {.unit = "px",
            .range = between(min_picture_width, max_picture_width),
            .fallback = "1280",
            .sentence = "Width of the picture, even."}),
    member(
        "px_per_mm", &PictureOptions::pixels_a_mm,
        {.range = above(0.0), .alternative = true, .sentence = "Instead of the width: px per mm."}),
    member("paper", &PictureOptions::paper,
           {.unit = "m",
            .range = between(0.01, 2.0),
            .alternative = true,
            .sentence = "Instead of the width: that on paper, as in 85*mm; its texts have 8 pt."}),
    member("dpi", &PictureOptions::dpi,
           {.range = between(30.0, 2400.0),
            .fallback = "300",
            .sentence = "Pixels per inch of paper; those of the plate in a PDF or SVG."}),
    member("font_size", &PictureOptions::font_size,
           {.unit = "pt",
            .range = between(2.0, 72.0),
            .fallback = "suits the width",
            .sentence = "Size of the texts on paper, in points of 1/72 inch; numbers have 0.8 of "
                        "it."}),
    member("field", &PictureOptions::field,
           {.fallback = "damage", .choices = scalar_names, .sentence = "Field to paint."}),
    member("range", &PictureOptions::range,
           {.fallback = suits_the_field,
            .sentence = "Values at the two ends of the colour bar, in SI units. The default "
                        "follows from the material; where over 1 % of what is seen lies beyond, it "
                        "widens 2, 5, 10, ... times, which the picture says."}),
    member(
        "percentile", &PictureOptions::percentile,
        {.range = between(50.0, 100.0),
         .alternative = true,
         .sentence = "Instead of a range: the colour bar spans this share of the values, in %."}),
    member("scale", &PictureOptions::scale,
           {.fallback = suits_the_field, .sentence = "Scale of the colour bar."}),
    member("colours", &PictureOptions::colours,
           {.fallback = suits_the_field,
            .choices = colour_map_names,
            .sentence = "Colour map of the colour bar."}),
    member("second", &PictureOptions::second,
           {.fallback = "none",
            .or_none = true,
            .choices = second_names,
            .sentence = "A second field in the same picture."}),
    member("arrange", &PictureOptions::arrangement,
           {.fallback = "below",
            .sentence = "Place of the second field: below or right of the midline, over the first, "
                        "or beside it."}),
    member("second_range", &PictureOptions::second_range,
           {.fallback = suits_the_field, .sentence = "Range of the second field."}),
    member("cracks", &PictureOptions::cracks,
           {.fallback = "true",
            .sentence = "Shows cracks as gaps, except in a picture of damage."}),
    member("smooth", &PictureOptions::smooth,
           {.fallback = "false",
            .sentence = "Interpolates between nodes that are joined; cracks stay sharp. Not in a "
                        "deformed or turned plate."}),
    member("average", &PictureOptions::average,
           {.fallback = "false",
            .sentence = "Averages over a horizon, not across cracks: takes short waves out, as in "
                        "fringes after a fork."}),
    member("thickness", &PictureOptions::thickness,
           {.unit = "m",
            .range = above(0.0),
            .fallback = "0.005",
            .sentence = "Thickness of the plate, for a picture of fringes."}),
    member("zoom", &PictureOptions::zoom,
           {.unit = "m",
            .range = above(0.0),
            .fallback = "the plate",
            .sentence =
                "Centre and half width of the visible part, which has the shape of the plate."}),
    member("follow", &PictureOptions::follow,
           {.fallback = "none",
            .or_none = true,
            .sentence = "Makes the zoom follow the foremost damage in this direction."}),
    member("rotate", &PictureOptions::rotation,
           {.unit = "rad",
            .range = between(-6.3, 6.3),
            .fallback = "0",
            .sentence = "Turns the picture anticlockwise; 90*deg puts the plate on end."}),
    member("deformed", &PictureOptions::deformed,
           {.fallback = "false",
            .sentence = "Shows the deformed plate, with displacements magnified."}),
    member("magnify", &PictureOptions::magnification,
           {.range = between(0.0, 1e9),
            .fallback = "depends on the plate",
            .sentence = "Magnification of displacements in a deformed plate."}),
    member("bonds", &PictureOptions::bonds,
           {.fallback = "false",
            .sentence = "Draws every visible bond, for a zoom on a few nodes."}),
    member("theme", &PictureOptions::look,
           {.fallback = "dark",
            .sentence = "Ground, texts and colour maps: light has a plate that is nearly white "
                        "where nothing happens."}),
    member("background", &PictureOptions::background,
           {.fallback = suits_the_theme,
            .sentence = "Background around the plate; transparent only in a PNG."}),
    member("", &PictureOptions::overlay));

}  // namespace hackle
