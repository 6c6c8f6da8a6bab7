// SPDX-License-Identifier: MIT
// The options of a movie, of a run or of a recording.
#pragma once

#include <array>

#include "console/language/picture_options.hpp"
#include "console/schema/arguments.hpp"
#include "movie/movie_kind.hpp"
#include "output/movie_options.hpp"

namespace hackle {

inline constexpr Option file_option{.name = "file",
                                    .type = OptionType::text,
                                    .required = true,
                                    .positional = true,
                                    .sentence = "File name; relative to the output folder."};
inline constexpr Option every_option{.name = "every",
                                     .unit = "s",
                                     .range = above(0.0),
                                     .required = true,
                                     .sentence = "Simulated time between frames or records."};

inline constexpr auto movie_options = joined(
    std::array{
        file_option,
        every_option,
        width_option,
        scale_option,
        Option{.name = "fps",
               .range = between(1.0, 240.0),
               .fallback = "30",
               .sentence = "Frames per second when played; in .gif at most 50, to 1/100 s."},
        Option{.name = "profile",
               .type = OptionType::choice,
               .fallback = "web",
               .choices = profile_names,
               .sentence = "Quality of the movie; some kinds can be lossless."},
        Option{.name = "crf",
               .type = OptionType::integer,
               .range = between(1.0, 63.0),
               .fallback = "18 in .mp4, 28 in .webm",
               .sentence = "Constant rate factor; lower is better and larger; up to 51 in .mp4, in "
                           "others none."},
        Option{.name = "hold",
               .unit = "s",
               .range = between(0.0, 3600.0),
               .fallback = "1",
               .sentence = "Time for which the last frame stays when played."},
        Option{.name = "fallback",
               .type = OptionType::flag,
               .fallback = "false",
               .sentence = "Uses the next best kind of file if an encoder is missing."},
    },
    picture_options);

// Reads these options, except `every`.
MovieOptions movie_of(const Arguments& arguments);

}  // namespace hackle
