// SPDX-License-Identifier: MIT
// Numbers of runs as a chart.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/chart/chart_options.hpp"
#include "output/chart/chart_source.hpp"
#include "render/diagram/diagram.hpp"

namespace hackle {

// Throws Error (refused) for options that do not go together.
void check(const std::string& who, const ChartOptions& options);

// Returns the diagram of `what`: one kind of chart (chart_kind.hpp), or columns of one unit, of
// every source. Throws Error (refused) if a source lacks them, with the nearest name, or units
// differ.
Diagram chart_of(const std::vector<ChartSource>& sources, const std::vector<std::string>& what,
                 const ChartOptions& options);

// Returns the name of the file with the numbers behind a chart: "speed.pdf" has "speed.chart.csv".
std::filesystem::path table_of_chart(std::filesystem::path picture);

// Writes the chart, as PNG, PDF or SVG, and the table of its numbers. Throws Error (files), Error
// (interrupted).
void write_chart(const Diagram& diagram, const ChartOptions& options,
                 const std::filesystem::path& path);

}  // namespace hackle
