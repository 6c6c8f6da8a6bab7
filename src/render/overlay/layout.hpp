// SPDX-License-Identifier: MIT
// The positions of all parts of a picture.
#pragma once

#include <vector>

#include "lattice/grid.hpp"
#include "render/overlay/overlay_text.hpp"
#include "render/overlay/rectangle.hpp"

namespace hackle {

// A part of a lattice, in whole cells; it may extend beyond the lattice.
struct Window {
  int left = 0, bottom = 0;  // column and row of its lower left cell
  int nx = 1, ny = 1;        // cells along x and y, at least 1
};

// Returns the window as a separate lattice at the same position.
Grid part(const Grid& grid, const Window& window);

// The position of a colour bar.
struct BarRoom {
  Rectangle label;    // its name, left of it or, if long, above it
  Rectangle colours;  // without its texts
  Rectangle ticks;    // its numbers, below it
};

// From top to bottom: caption, plate, legend (colour bar left, scale bar right), charts. Absent
// parts are empty; all others lie inside the picture and do not overlap.
struct Layout {
  int width = 0;                              // px, even unless bare
  int height = 0;                             // px, even unless bare
  double font = 0.0;                          // px, of titles, time and names; 0 without any text
  double small_font = 0.0;                    // px, of numbers and remarks
  int hairline = 1;                           // px, of rims and marks
  Rectangle caption;                          // all lines above the plate
  Rectangle title, note, clock, slow_motion;  // one line each, in the caption
  Rectangle plate;
  Rectangle second_plate;     // same size, below or right of the first; usually empty
  std::vector<BarRoom> bars;  // one below the other
  Rectangle scale;            // room for the scale bar with its text
  Rectangle load_curve, energy;
  int foot = 0;  // px from the top: lower limit of discs, upper limit of the legend
};

// The size of a plate in a picture.
struct PlateSize {
  double cell = 0.0;  // px per cell; 0: as large as possible
  bool twice = false;
};

// Makes a layout for a picture of even `width`, px. Unless the cell size is given, cells of at
// least 3 px are whole pixels, so that all look alike. A tall plate shrinks until it is at most as
// high as the picture is wide. Texts that do not fit side by side get separate lines; texts that
// are still too long must be shortened to their rectangles. Throws what Font throws.
Layout make_layout(const Grid& grid, int width, const OverlayText& text = {},
                   const PlateSize& size = {});

// Returns the length of the marks of axes, px, whose numbers have this size.
int axis_mark(double small_font);

// Returns the smallest even width, px, of a picture that holds plates of the given size.
int width_for(const Grid& grid, const PlateSize& size);

// Returns a layout in which the plate alone fills the picture: width x height px, even or odd, of
// any shape.
Layout bare_layout(int width, int height);

// Returns the largest of 1, 2, 5 times a power of ten that is at most `most` (> 0): round lengths
// and ticks.
double neat_at_most(double max);

}  // namespace hackle
