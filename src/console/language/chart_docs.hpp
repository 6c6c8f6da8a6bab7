// SPDX-License-Identifier: MIT
// The options of charts.
#pragma once

#include <array>
#include <string_view>

#include "console/language/noun_options.hpp"
#include "console/language/picture_options.hpp"
#include "console/language/scripted_source.hpp"
#include "console/schema/schema.hpp"
#include "output/chart/chart_options.hpp"

namespace hackle {

inline constexpr std::string_view usual_chart = "energy";

inline constexpr std::array what_option{
    Option{.name = "what",
           .type = OptionType::texts,
           .range = at_least(1.0),
           .rest = true,
           .fallback = usual_chart,
           .sentence = "A kind of chart, see help \"charts\", or columns of one unit, see help "
                       "\"columns\"; they may stand behind the file."}};

inline constexpr std::array of_options{
    Option{.name = "of",
           .type = OptionType::sources,
           .read = read_sources,
           .range = at_least(1.0),
           .required = true,
           .sentence = "What is drawn: names of run files and of tables, recordings, simulations, "
                       "and numbers of the script."},
    Option{.name = "names",
           .type = OptionType::texts,
           .range = at_least(1.0),
           .fallback = "those of the files",
           .sentence = "Names of these in the chart, one for each."}};

inline constexpr auto own_chart_options =
    joined(joined(file_option, what_option), options_of<ChartOptions>);
inline constexpr auto chart_options = joined(own_chart_options, of_options);

inline constexpr FunctionDoc chart_doc{
    .name = "chart",
    .sentence =
        "Draws a chart of numbers of runs or of the script: .png, .pdf or .svg, with the "
        "table behind it beside it (.chart.csv).",
    .options = chart_options,
    .example =
        "chart { \"ladder.png\", of = { { load = {6, 12, 24}, branches = {0, 2, 4} } }, x = "
        "\"load\", \"branches\" }"};

inline constexpr FunctionDoc run_chart_doc{
    .name = "chart",
    .owner = "s",
    .sentence = "Draws a chart of what s:log has noted so far, or a histogram of a field.",
    .options = own_chart_options,
    .example =
        "s:log { \"run.csv\", every = 0.1*us, \"tip.speed\" } s:run(2*us)\n"
        "s:chart { \"speed.pdf\", \"speed\", paper = 85*mm }"};

inline constexpr FunctionDoc recorded_chart_doc{
    .name = "chart",
    .owner = "r",
    .sentence = "Draws a chart of the tables in a run file, and of its records for what they lack.",
    .options = own_chart_options,
    .example = "r:chart { \"tip.png\", \"tip.x\", \"tip.y\" }"};

}  // namespace hackle
