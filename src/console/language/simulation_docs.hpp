// SPDX-License-Identifier: MIT
// The options of simulate and of the methods of a simulation.
#pragma once

#include <algorithm>
#include <array>

#include "console/language/error_budget.hpp"
#include "console/language/noun_options.hpp"
#include "console/language/picture_options.hpp"
#include "console/language/region_options.hpp"
#include "console/schema/schema.hpp"
#include "lattice/numerics.hpp"
#include "output/files/record_options.hpp"

namespace hackle {

// Those of the numerics, and an error budget instead of the spacing.
inline constexpr auto simulate_options = [] {
  constexpr auto& own = options_of<Numerics>;
  std::array<Option, own.size() + 2> all{};
  std::ranges::copy(own, all.begin());
  for (Option& option : all)
    if (option.name == "spacing") option.unless = "within";
  all[own.size()] = within_option;
  all[own.size() + 1] = verify_option;
  return all;
}();
inline constexpr FunctionDoc simulate_doc{
    .name = "simulate",
    .leading = "p",
    .sentence = "Puts a copy of the plate on a lattice, ready to run.",
    .options = simulate_options,
    .example = "s = simulate(p, { spacing = 0.5*mm, horizon = 2*mm })"};

inline constexpr std::array run_options{
    Option{.name = "duration",
           .unit = "s",
           .range = at_least(0.0),
           .required = true,
           .sentence = "Simulated time to run."},
};

inline constexpr FunctionDoc run_doc{.name = "run",
                                     .owner = "s",
                                     .call = Call::values,
                                     .sentence =
                                         "Runs for this simulated time, and shows the "
                                         "plate as it is then (help \"times\").",
                                     .options = run_options,
                                     .example = "s:run(1*us)"};

inline constexpr std::array step_options{
    Option{.name = "count",
           .type = OptionType::integer,
           .unit = "steps",
           .range = between(0.0, 1e12),
           .fallback = "1",
           .sentence = "Number of time steps."},
};

inline constexpr FunctionDoc step_doc{.name = "step",
                                      .owner = "s",
                                      .call = Call::values,
                                      .sentence = "Runs this many time steps.",
                                      .options = step_options,
                                      .example = "s:step(10)"};

inline constexpr auto movie_options = joined(file_option, options_of<MovieOptions>);

inline constexpr FunctionDoc movie_doc{
    .name = "movie",
    .owner = "s",
    .sentence =
        "Makes a movie of the following run: .mp4, .webm, .mkv, .mov, .gif, .apng or .webp.",
    .options = movie_options,
    .example = "s:movie { \"crack.mp4\", field = \"damage\", every = 0.25*us }"};

inline constexpr auto frame_options = joined(file_option, options_of<PictureOptions>);

inline constexpr FunctionDoc frame_doc{.name = "frame",
                                       .owner = "s",
                                       .sentence =
                                           "Writes a picture of the present state: .png, or .pdf "
                                           "or .svg with texts and lines as vectors.",
                                       .options = frame_options,
                                       .example =
                                           "s:frame { \"crack.png\", width = 640 }\n"
                                           "s:frame { \"crack.pdf\", paper = 85*mm, theme = "
                                           "\"light\", axes = true }"};

inline constexpr auto record_options = [] {
  auto options = joined(file_option, joined(options_of<RecordOptions>, region_options));
  for (Option& option : options)
    if (option.name == "every") {
      option.required = true;
      option.unless = "steps";
      option.alternative = false;
    }
  return options;
}();

inline constexpr FunctionDoc record_doc{
    .name = "record",
    .owner = "s",
    .sentence = "Records the following run in an HDF5 file that ParaView opens.",
    .options = record_options,
    .example =
        "s:record { \"crack.h5\", every = 1*us }\n"
        "s:record { \"tip.h5\", steps = 5, fields = { \"stress_1\", \"damage\" },\n"
        "  from = { 0, 2*mm }, to = { 10*mm, 8*mm }, coarsen = 2 }"};

inline constexpr FunctionDoc report_doc{.name = "report",
                                        .owner = "s",
                                        .call = Call::values,
                                        .sentence = "Returns a report of the run so far as text.",
                                        .example = "print(s:report())"};

inline constexpr FunctionDoc close_doc{
    .name = "close",
    .owner = "s",
    .call = Call::values,
    .sentence = "Completes its movies and records; the end of the script also does so.",
    .example = "s:close()"};

}  // namespace hackle
