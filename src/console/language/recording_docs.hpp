// SPDX-License-Identifier: MIT
// The options of recording, the methods of a recording, and side_by_side.
#pragma once

#include <array>

#include "console/language/picture_options.hpp"
#include "console/language/scripted_recording.hpp"
#include "console/language/simulation_docs.hpp"
#include "console/schema/schema.hpp"
#include "output/files/replay_options.hpp"

namespace hackle {

inline constexpr std::array recording_options{
    Option{.name = "file",
           .type = OptionType::text,
           .required = true,
           .positional = true,
           .sentence = "File written by s:record{}, beside the script or in the output folder."},
};

inline constexpr FunctionDoc recording_doc{
    .name = "recording",
    .sentence = "Opens a recorded run for viewing, without computing.",
    .options = recording_options,
    .example =
        "s:record { \"crack.h5\", every = 1*us } s:run(2*us) s:close()\n"
        "r = recording \"crack.h5\""};

inline constexpr auto recorded_frame_options =
    joined(file_option, joined(options_of<ShownRecord>, options_of<PictureOptions>));

inline constexpr FunctionDoc recorded_frame_doc{
    .name = "frame",
    .owner = "r",
    .sentence = "Writes a picture of one record: .png, .pdf or .svg.",
    .options = recorded_frame_options,
    .example = "r:frame { \"crack.png\", time = 1*us, field = \"stress_1\" }"};

inline constexpr auto recorded_movie_options =
    joined(file_option, joined(options_of<Moments>, without("every", options_of<MovieOptions>)));

inline constexpr FunctionDoc recorded_movie_doc{
    .name = "movie",
    .owner = "r",
    .sentence = "Makes a movie of the records.",
    .options = recorded_movie_options,
    .example = "r:movie { \"crack.mp4\", field = \"von_mises\", percentile = 99 }"};

inline constexpr std::array recordings_option{
    Option{.name = "recordings",
           .type = OptionType::recordings,
           .read = read_recordings,
           .range = at_least(1.0),
           .required = true,
           .sentence = "Recordings, as returned by recording."}};

// Every run has a width instead of a movie.
inline constexpr auto side_by_side_options =
    joined(joined(recordings_option, options_of<SideBySideOptions>),
           without("width", recorded_movie_options));

inline constexpr FunctionDoc side_by_side_doc{
    .name = "side_by_side",
    .sentence = "Makes a movie of several recorded runs, with a common clock and colour bar.",
    .options = side_by_side_options,
    .example = "side_by_side { \"both.mp4\", recordings = { r, r }, titles = { \"a\", \"b\" } }"};

}  // namespace hackle
