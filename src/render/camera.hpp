// SPDX-License-Identifier: MIT
// Where a place of the lattice lies in the picture.
#pragma once

#include "render/layout.hpp"

namespace hackle {

class Camera {
 public:
  // Shows the window, turned counterclockwise by `rotation`, rad, about its middle, in the
  // rectangle that the plate has in the picture.
  Camera(const Grid& grid, const Window& window, double rotation, const Rectangle& plate);

  // Of a point given in cells from the lower left corner of the lattice: -1..1 over the rectangle,
  // x right, y up.
  Vec2 share(const Vec2& cells) const;
  // The same in px of the picture, y down.
  Vec2 pixel_of_cells(const Vec2& cells) const;
  // The same of a place given in m.
  Vec2 pixel(const Vec2& place) const;
  // px that a metre takes along x and y; they differ in a stretched picture.
  Vec2 pixels_a_metre() const;

 private:
  Grid grid_;
  Rectangle plate_;
  Vec2 middle_;       // of the window, in cells
  Vec2 half_;         // of its size, in cells
  double cos_, sin_;  // of the rotation
};

// Of the rectangle around one of this size that is turned by `rotation`, rad.
Vec2 turned_size(const Vec2& size, double rotation);

// The window, in whole cells, that shows all of a lattice turned by `rotation`, rad, with so many
// cells free on each side.
Window whole_window(const Grid& grid, double rotation, int margin);

}  // namespace hackle
