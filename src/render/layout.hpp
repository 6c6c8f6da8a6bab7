// SPDX-License-Identifier: MIT
// Where the parts of a picture lie. Pure arithmetic.
#pragma once

#include <string>

#include "lattice/grid.hpp"

namespace hackle {

// In px from the upper left corner.
struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;

  int right() const { return x + width; }
  int bottom() const { return y + height; }
};

// A part of a lattice, in whole cells; it may reach beyond the lattice.
struct Window {
  int left = 0, bottom = 0;  // column and row of its lower left cell
  int nx = 1, ny = 1;        // cells along x and y, at least 1
};

// The window as a lattice of its own, in the same place.
Grid part(const Grid& grid, const Window& window);

// From top to bottom: the caption (title left, time right), the plate, the legend (colour bar left,
// scale bar right). The parts never overlap.
struct Layout {
  int width = 0;            // px, even unless bare
  int height = 0;           // px, even unless bare
  double font = 0.0;        // px, of the captions
  double small_font = 0.0;  // px, of the ticks
  Rectangle caption;
  Rectangle plate;
  Rectangle bar;    // the colours of the colour bar, without its texts
  Rectangle scale;  // where the scale bar may lie, with its text
};

// For a picture `width` px wide, even. Cells are whole pixels when they are at least 3 px, so that
// all look alike. A tall plate is made smaller until the plate is at most as high as the picture is
// wide. `label` is what the name before the colour bar takes, in units of the font; the height does
// not depend on it.
inline constexpr double shortest_label = 6.0;
Layout make_layout(const Grid& grid, int width, double label = shortest_label);
// What a name takes, with some room behind it.
double label_ems(const std::string& name);

// The plate alone fills the picture: width x height px, even or not, whatever its shape.
Layout bare_layout(int width, int height);

// The largest of 1, 2, 5 times a power of ten that is at most `most` (> 0): neat lengths and ticks.
double neat_at_most(double most);

}  // namespace hackle
