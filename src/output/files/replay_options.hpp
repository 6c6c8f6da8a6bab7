// SPDX-License-Identifier: MIT
// What a user may say of pictures, movies and sheets of recorded runs, besides how a picture is
// made.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/described.hpp"
#include "output/files/movie_options.hpp"

namespace hackle {

// The times of frames: equally spaced, each showing the nearest record. A run that has ended stays
// in its final state.
struct Moments {
  std::optional<double> from;   // s; default: the first record of all runs
  std::optional<double> to;     // s, above from; default: the last record of all runs
  std::optional<double> every;  // s; default: the spacing of records in the run with the most
};

template <>
inline constexpr auto description_of<Moments> = describe_noun(
    "movie", "movie",
    member("every", &Moments::every,
           {.unit = "s",
            .range = above(0.0),
            .fallback = "one frame per record",
            .sentence = "Simulated time between frames; each shows the nearest record."}),
    member("from", &Moments::from,
           {.unit = "s", .fallback = "the start", .sentence = "Beginning of the movie."}),
    member("to", &Moments::to,
           {.unit = "s", .fallback = "the end", .sentence = "End of the movie."}));

// Which record a picture shows: the nearest.
struct ShownRecord {
  std::optional<double> time;  // s; the last one if not given
};

template <>
inline constexpr auto description_of<ShownRecord> =
    describe_noun("record", "record",
                  member("time", &ShownRecord::time,
                         {.unit = "s",
                          .fallback = "the end",
                          .sentence = "Time of the record to show, of a recording."}));

inline constexpr About about_titles{.range = at_least(1.0),
                                    .fallback = "the names of the files, or of their folders",
                                    .sentence = "Caption below each."};
inline constexpr About about_letters{.fallback = "false",
                                     .sentence = "Puts (a), (b), (c), ... before each caption."};

// Several runs on one clock.
struct SideBySideOptions {
  std::vector<std::string> titles;  // one for each run, or none
  bool letters = false;
  int columns = 2;
  int width = 640;  // px, of each run
};

template <>
inline constexpr auto description_of<SideBySideOptions> = describe_noun(
    "side_by_side", "side by side", member("titles", &SideBySideOptions::titles, about_titles),
    member("letters", &SideBySideOptions::letters, about_letters),
    member("columns", &SideBySideOptions::columns,
           {.range = between(1.0, 16.0), .fallback = "2", .sentence = "Number of runs per row."}),
    member("width", &SideBySideOptions::width,
           {.unit = "px",
            .range = between(min_picture_width, 4096.0),
            .fallback = "640",
            .sentence = "Width of each run's picture, even."}));

// Many pictures on one.
struct SheetOptions {
  std::vector<std::string> pictures;  // PNGs; or runs, in which case there are none
  std::vector<double> times;          // s, of runs
  std::vector<std::string> titles;    // one for each picture or run, or none
  bool letters = false;
  int columns = 4;
  int width = 320;  // px, of each picture
};

template <>
inline constexpr auto description_of<SheetOptions> = describe_noun(
    "contact_sheet", "contact sheet",
    member("pictures", &SheetOptions::pictures,
           {.range = at_least(1.0),
            .alternative = true,
            .sentence = "Existing PNGs; relative to the output folder."}),
    member("times", &SheetOptions::times,
           {.unit = "s",
            .range = at_least(1.0),
            .fallback = "the end",
            .sentence = "Times of recordings: one column per time; of one recording, in columns "
                        "like pictures."}),
    member("titles", &SheetOptions::titles, about_titles),
    member("letters", &SheetOptions::letters, about_letters),
    member(
        "columns", &SheetOptions::columns,
        {.range = between(1.0, 64.0), .fallback = "4", .sentence = "Number of pictures per row."}),
    member("width", &SheetOptions::width,
           {.unit = "px",
            .range = between(64.0, 4096.0),
            .fallback = "320",
            .sentence =
                "Width of each picture; a row is as high as its highest picture, of a PNG at most "
                "3/4 of the width."}));

}  // namespace hackle
