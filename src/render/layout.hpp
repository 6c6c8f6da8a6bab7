// SPDX-License-Identifier: MIT
// Where the parts of a picture lie.
#pragma once

#include <vector>

#include "lattice/grid.hpp"
#include "render/overlay_text.hpp"
#include "render/rectangle.hpp"

namespace hackle {

// A part of a lattice, in whole cells; it may reach beyond the lattice.
struct Window {
  int left = 0, bottom = 0;  // column and row of its lower left cell
  int nx = 1, ny = 1;        // cells along x and y, at least 1
};

// The window as a lattice of its own, in the same place.
Grid part(const Grid& grid, const Window& window);

// Where a colour bar lies.
struct BarRoom {
  Rectangle label;    // its name, left of it or, where it is long, above it
  Rectangle colours;  // without its texts
  Rectangle ticks;    // its numbers, below it
};

// From top to bottom: the caption, the plate, the legend (colour bar left, scale bar right),
// charts. What is not shown is empty; all else lies inside the picture and no two overlap.
struct Layout {
  int width = 0;            // px, even unless bare
  int height = 0;           // px, even unless bare
  double font = 0.0;        // px, of titles, time and names; 0 when nothing is written
  double small_font = 0.0;  // px, of numbers and remarks
  int hairline = 1;         // px, of rims and marks
  Rectangle caption;        // all lines above the plate
  Rectangle title, note, clock, slow_motion;  // of one line each, in the caption
  Rectangle plate;
  Rectangle second_plate;     // of the same size, below or right of the first one; mostly empty
  std::vector<BarRoom> bars;  // one below the other
  Rectangle scale;            // where the scale bar may lie, with its text
  Rectangle load_curve, energy;
  int foot = 0;  // px from the top; discs are seen down to here, the legend begins below it
};

// How a picture shows a plate.
struct PlateSize {
  double cell = 0.0;  // px of a cell; 0: as large as it can be
  bool twice = false;
};

// For a picture `width` px wide, even. Cells are whole pixels when they are at least 3 px, so that
// all look alike, unless their size is given. A tall plate is made smaller until the plate is at
// most as high as the picture is wide. Texts that do not fit beside each other get lines of their
// own; what is still too long is to be shortened to its rectangle. Throws what Font throws.
Layout make_layout(const Grid& grid, int width, const OverlayText& text = {},
                   const PlateSize& size = {});

// The least width, px, of a picture that holds plates of the size that is given; even.
int width_for(const Grid& grid, const PlateSize& size);

// The plate alone fills the picture: width x height px, even or not, whatever its shape.
Layout bare_layout(int width, int height);

// The largest of 1, 2, 5 times a power of ten that is at most `most` (> 0): neat lengths and ticks.
double neat_at_most(double most);

}  // namespace hackle
