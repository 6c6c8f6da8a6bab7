// SPDX-License-Identifier: MIT
#include "render/camera.hpp"

#include <cmath>

namespace hackle {
namespace {

// Returns a number of cells that is at least `size` and has the same midpoint as `count` cells.
int cells_around(double size, int count) {
  // The cosine of a right angle is 6e-17, which must not add a cell.
  constexpr double slack = 1e-9;
  const int cells = static_cast<int>(std::ceil(size - slack));
  return cells + (cells + count) % 2;
}

}  // namespace

Camera::Camera(const Grid& grid, const Window& window, double rotation, const Rectangle& plate)
    : grid_(grid),
      plate_(plate),
      middle_(window.left + 0.5 * window.nx, window.bottom + 0.5 * window.ny),
      half_(0.5 * window.nx, 0.5 * window.ny),
      cos_(std::cos(rotation)),
      sin_(std::sin(rotation)) {
}

Vec2 Camera::share(const Vec2& cells) const {
  const Vec2 from = cells - middle_;
  return Vec2(cos_ * from.x() - sin_ * from.y(), sin_ * from.x() + cos_ * from.y())
      .cwiseQuotient(half_);
}

Vec2 Camera::pixel(const Vec2& place) const {
  return pixel_of_cells(grid_.from_centre(place) + 0.5 * Vec2(grid_.nx, grid_.ny));
}

Vec2 Camera::pixel_of_cells(const Vec2& cells) const {
  const Vec2 at = share(cells);
  return {plate_.x + 0.5 * plate_.width * (1.0 + at.x()),
          plate_.y + 0.5 * plate_.height * (1.0 - at.y())};
}

Vec2 Camera::place(const Vec2& pixel) const {
  const Vec2 share(2.0 * (pixel.x() - plate_.x) / plate_.width - 1.0,
                   1.0 - 2.0 * (pixel.y() - plate_.y) / plate_.height);
  const Vec2 turned = share.cwiseProduct(half_);
  const Vec2 cells(cos_ * turned.x() + sin_ * turned.y(), -sin_ * turned.x() + cos_ * turned.y());
  return grid_.centre + grid_.dx * (middle_ + cells - 0.5 * Vec2(grid_.nx, grid_.ny));
}

Vec2 Camera::pixels_a_metre() const {
  return {0.5 * plate_.width / (half_.x() * grid_.dx),
          0.5 * plate_.height / (half_.y() * grid_.dx)};
}

Vec2 turned_size(const Vec2& size, double rotation) {
  const double c = std::abs(std::cos(rotation)), s = std::abs(std::sin(rotation));
  return {c * size.x() + s * size.y(), s * size.x() + c * size.y()};
}

Window whole_window(const Grid& grid, double rotation, int margin) {
  const Vec2 size = turned_size({grid.nx, grid.ny}, rotation);
  Window window;
  window.nx = cells_around(size.x(), grid.nx) + 2 * margin;
  window.ny = cells_around(size.y(), grid.ny) + 2 * margin;
  window.left = (grid.nx - window.nx) / 2;
  window.bottom = (grid.ny - window.ny) / 2;
  return window;
}

}  // namespace hackle
