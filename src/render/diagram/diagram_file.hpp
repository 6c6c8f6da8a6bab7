// SPDX-License-Identifier: MIT
// A diagram as a picture, and the numbers behind it.
#pragma once

#include <filesystem>
#include <string>

#include "render/diagram/diagram.hpp"
#include "render/diagram/diagram_drawing.hpp"
#include "render/theme.hpp"

namespace hackle {

struct DiagramStyle {
  DiagramSize size;
  double dpi = 300.0;  // px per inch of paper, in a file of vectors
  Look look = Look::light;
};

// Writes a PNG, or a PDF or SVG by the ending of its name, under a partial name, then renames it.
// Throws Error (files), and Error (interrupted) on Ctrl-C.
void write_diagram(const Diagram& diagram, const DiagramStyle& style,
                   const std::filesystem::path& path);

// Returns a table, CSV in SI units: an x for each group of curves that share it, and their y behind
// it; empty where there is no number. Names of columns are letters, digits and _, and differ.
std::string csv_of(const Diagram& diagram);

}  // namespace hackle
