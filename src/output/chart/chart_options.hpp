// SPDX-License-Identifier: MIT
// The user's options for a chart of numbers of a run.
#pragma once

#include <optional>
#include <string>

#include "base/described.hpp"
#include "measure/scalar.hpp"
#include "output/picture/picture.hpp"
#include "render/theme.hpp"

namespace hackle {

struct ChartOptions {
  std::string x = "time";                // a column
  std::optional<std::string> title;      // default: of the kind
  std::string field = "damage";          // of a histogram, one of scalar_names
  int bins = 40;                         // of a histogram
  std::optional<double> time;            // s, of the record for a histogram; default: the last
  std::optional<Ends> x_range, y_range;  // SI
  Scale x_scale = Scale::linear, y_scale = Scale::linear;
  int width = 1280;                 // px
  std::optional<double> paper;      // m, the width on paper, instead
  double dpi = 300.0;               // px per inch of paper
  std::optional<double> font_size;  // pt, on paper
  Look look = Look::light;
};

template <>
inline constexpr auto description_of<ChartOptions> = describe_noun(
    "chart", "chart",
    member("x", &ChartOptions::x,
           {.fallback = "time", .sentence = "Column along the x axis, as \"grip.uy\"."}),
    member("title", &ChartOptions::title,
           {.fallback = "that of its kind", .sentence = "Title above the chart; \"\" for none."}),
    member("field", &ChartOptions::field,
           {.fallback = "damage", .choices = scalar_names, .sentence = "Field of a histogram."}),
    member("bins", &ChartOptions::bins,
           {.range = between(2.0, 1000.0),
            .fallback = "40",
            .sentence = "Number of bins of a histogram."}),
    member("time", &ChartOptions::time,
           {.unit = "s",
            .range = at_least(0.0),
            .fallback = "the last",
            .sentence = "Time of the record of a histogram, the nearest there is."}),
    member("x_range", &ChartOptions::x_range,
           {.fallback = "all", .sentence = "Values at the two ends of the x axis, SI."}),
    member("y_range", &ChartOptions::y_range,
           {.fallback = "all", .sentence = "Values at the two ends of the y axis, SI."}),
    member("x_scale", &ChartOptions::x_scale,
           {.fallback = "linear", .sentence = "Scale of the x axis."}),
    member("y_scale", &ChartOptions::y_scale,
           {.fallback = "linear", .sentence = "Scale of the y axis."}),
    member("width", &ChartOptions::width,
           {.unit = "px",
            .range = between(min_picture_width, max_picture_width),
            .fallback = "1280",
            .sentence = "Width of the chart."}),
    member("paper", &ChartOptions::paper,
           {.unit = "m",
            .range = between(0.01, 2.0),
            .alternative = true,
            .sentence = "Instead of the width: that on paper, as in 85*mm; its texts have 8 pt."}),
    member("dpi", &ChartOptions::dpi,
           {.range = between(30.0, 2400.0),
            .fallback = "300",
            .sentence = "Pixels per inch of paper."}),
    member("font_size", &ChartOptions::font_size,
           {.unit = "pt",
            .range = between(2.0, 72.0),
            .fallback = "suits the width",
            .sentence = "Size of the texts on paper, in points of 1/72 inch."}),
    member("theme", &ChartOptions::look,
           {.fallback = "light", .sentence = "Ground and texts: light, or dark as pictures are."}));

}  // namespace hackle
