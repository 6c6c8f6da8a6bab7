// SPDX-License-Identifier: MIT
// Maps places of the lattice to the picture.
#pragma once

#include "render/overlay/layout.hpp"

namespace hackle {

class Camera {
 public:
  // Shows the window, turned anticlockwise by `rotation` (rad) about its centre, in the plate's
  // rectangle of the picture.
  Camera(const Grid& grid, const Window& window, double rotation, const Rectangle& plate);

  // Maps a point in cells from the lower left corner of the lattice to -1..1 over the rectangle, x
  // right, y up.
  Vec2 share(const Vec2& cells) const;
  // Maps the same point to px of the picture, y down.
  Vec2 pixel_of_cells(const Vec2& cells) const;
  // Maps a point in m to px of the picture.
  Vec2 pixel(const Vec2& place) const;
  // Returns the point in m that is seen at these px.
  Vec2 place(const Vec2& pixel) const;
  // Returns px per metre along x and y; they differ in a stretched picture.
  Vec2 pixels_a_metre() const;

 private:
  Grid grid_;
  Rectangle plate_;
  Vec2 middle_;       // of the window, in cells
  Vec2 half_;         // half its size, in cells
  double cos_, sin_;  // of the rotation
};

// Returns the size of the box around a rectangle of size `size` turned by `rotation`, rad.
Vec2 turned_size(const Vec2& size, double rotation);

// Returns the window, in whole cells, that shows a whole lattice turned by `rotation` (rad), with
// `margin` free cells on each side.
Window whole_window(const Grid& grid, double rotation, int margin);

}  // namespace hackle
