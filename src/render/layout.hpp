// SPDX-License-Identifier: MIT
// Where the parts of a picture lie. Pure arithmetic.
#pragma once

#include "lattice/grid.hpp"

namespace hackle {

// In px from the upper left corner.
struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;

  int right() const { return x + width; }
  int bottom() const { return y + height; }
};

// From top to bottom: the caption (title left, time right), the plate, the legend (colour bar left,
// scale bar right). The parts never overlap.
struct Layout {
  int width = 0;            // px, even
  int height = 0;           // px, even
  double font = 0.0;        // px, of the captions
  double small_font = 0.0;  // px, of the ticks
  Rectangle caption;
  Rectangle plate;
  Rectangle bar;    // the colours of the colour bar, without its texts
  Rectangle scale;  // where the scale bar may lie, with its text
};

// For a picture `width` px wide, even. Cells are whole pixels when they are at least 3 px, so that
// all look alike. A tall plate is made smaller until the plate is at most as high as the picture is
// wide.
Layout make_layout(const Grid& grid, int width);

// The largest of 1, 2, 5 times a power of ten that is at most `most` (> 0): neat lengths and ticks.
double neat_at_most(double most);

}  // namespace hackle
