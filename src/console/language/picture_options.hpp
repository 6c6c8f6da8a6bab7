// SPDX-License-Identifier: MIT
// What functions that make pictures and movies take.
#pragma once

#include <any>
#include <array>
#include <string_view>
#include <vector>

#include "console/language/noun_options.hpp"
#include "output/files/movie_options.hpp"

namespace hackle {

// A list of Marker: {x, y, "label"}.
std::any read_markers(const GivenValue& given);
void read_given(const Arguments& arguments, std::string_view name, const About& about, Ends& ends);
void read_given(const Arguments& arguments, std::string_view name, const About& about, Zoom& zoom);

template <>
inline constexpr std::optional<OwnWay> own_way<Ends> = OwnWay{OptionType::pair};
template <>
inline constexpr std::optional<OwnWay> own_way<Zoom> = OwnWay{OptionType::window};
template <>
inline constexpr std::optional<OwnWay> own_way<std::vector<Marker>> =
    OwnWay{OptionType::markers, read_markers};

inline constexpr std::array file_option{
    Option{.name = "file",
           .type = OptionType::text,
           .required = true,
           .positional = true,
           .sentence = "File name; relative to the output folder."}};

// Where the size is given otherwise, or by the terminal.
inline constexpr auto unsized_picture_options = without(
    "width",
    without("px_per_mm",
            without("paper", without("dpi", without("font_size", options_of<PictureOptions>)))));

}  // namespace hackle
