// SPDX-License-Identifier: MIT
// The options of recording, the methods of a recording, and side_by_side.
#pragma once

#include <array>

#include "console/language/picture_options.hpp"
#include "console/language/scripted_recording.hpp"
#include "console/language/simulation_docs.hpp"
#include "console/schema/schema.hpp"

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

// Selects the nearest record.
inline constexpr Option time_option{
    .name = "time", .unit = "s", .fallback = "the end", .sentence = "Time of the record to show."};

inline constexpr auto recorded_frame_options =
    joined(std::array{file_option, time_option, width_option, scale_option}, picture_options);

inline constexpr FunctionDoc recorded_frame_doc{
    .name = "frame",
    .owner = "r",
    .sentence = "Writes a picture of one record, a PNG.",
    .options = recorded_frame_options,
    .example = "r:frame { \"crack.png\", time = 1*us, field = \"stress_1\" }"};

// The times of a movie made from records.
inline constexpr std::array moment_options{
    Option{.name = "every",
           .unit = "s",
           .range = above(0.0),
           .fallback = "one frame per record",
           .sentence = "Simulated time between frames; each shows the nearest record."},
    Option{.name = "from",
           .unit = "s",
           .fallback = "the start",
           .sentence = "Beginning of the movie."},
    Option{.name = "to", .unit = "s", .fallback = "the end", .sentence = "End of the movie."},
};

inline constexpr auto recorded_movie_options =
    joined(moment_options, without("every", movie_options));

inline constexpr FunctionDoc recorded_movie_doc{
    .name = "movie",
    .owner = "r",
    .sentence = "Makes a movie of the records.",
    .options = recorded_movie_options,
    .example = "r:movie { \"crack.mp4\", field = \"von_mises\", percentile = 99 }"};

inline constexpr Option recordings_option{.name = "recordings",
                                          .type = OptionType::recordings,
                                          .read = read_recordings,
                                          .range = at_least(1.0),
                                          .required = true,
                                          .sentence = "Recordings, as returned by recording."};
inline constexpr Option run_titles_option{.name = "titles",
                                          .type = OptionType::texts,
                                          .range = at_least(1.0),
                                          .fallback = "the file names",
                                          .sentence = "Caption below each."};

inline constexpr auto side_by_side_options =
    joined(joined(std::array{recordings_option, run_titles_option,
                             Option{.name = "columns",
                                    .type = OptionType::integer,
                                    .range = between(1.0, 16.0),
                                    .fallback = "2",
                                    .sentence = "Number of runs per row."},
                             Option{.name = "width",
                                    .type = OptionType::integer,
                                    .unit = "px",
                                    .range = between(320.0, 4096.0),
                                    .fallback = "640",
                                    .sentence = "Width of each run's picture, even."}},
                  moment_options),
           without("width", without("every", movie_options)));

inline constexpr FunctionDoc side_by_side_doc{
    .name = "side_by_side",
    .sentence = "Makes a movie of several recorded runs, with a common clock and colour bar.",
    .options = side_by_side_options,
    .example = "side_by_side { \"both.mp4\", recordings = { r, r }, titles = { \"a\", \"b\" } }"};

}  // namespace hackle
