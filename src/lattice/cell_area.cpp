// SPDX-License-Identifier: MIT
#include "lattice/cell_area.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hackle {
namespace {

// Area and first moments of a region, summed strip by strip.
struct Moments {
  double area = 0.0, x = 0.0, y = 0.0;
};

// Adds the rectangle [left, right] x [bottom, top].
void add_rectangle(Moments& sum, double left, double right, double bottom, double top) {
  const double area = (right - left) * (top - bottom);
  sum.area += area;
  sum.x += 0.5 * area * (left + right);
  sum.y += 0.5 * area * (bottom + top);
}

// Adds the region above `bottom` and below the circle, between left and right.
void add_cap(Moments& sum, double left, double right, double bottom, double radius) {
  const auto height = [&](double x) { return std::sqrt(std::max(radius * radius - x * x, 0.0)); };
  const auto area = [&](double x) {
    return 0.5 * (x * height(x) + radius * radius * std::asin(std::min(x / radius, 1.0))) -
           bottom * x;
  };
  const auto moment_x = [&](double x) {
    return -std::pow(height(x), 3) / 3.0 - 0.5 * bottom * x * x;
  };
  const auto moment_y = [&](double x) {
    return 0.5 * ((radius * radius - bottom * bottom) * x - x * x * x / 3.0);
  };
  sum.area += area(right) - area(left);
  sum.x += moment_x(right) - moment_x(left);
  sum.y += moment_y(right) - moment_y(left);
}

// Returns the abscissa at which the circle has the height y; 0 if there is none.
double where_height_is(double y, double radius) {
  return y < radius ? std::sqrt(radius * radius - y * y) : 0.0;
}

}  // namespace

CellPart cell_inside_circle(int a, int b, double radius) {
  // In the upper octant the circle is flat enough for vertical strips.
  if (a > b) {
    CellPart turned = cell_inside_circle(b, a, radius);
    std::swap(turned.centroid.x(), turned.centroid.y());
    return turned;
  }
  // For a cell on the axis, only the right half is computed: the left half is its mirror image.
  const bool on_axis = a == 0;
  const double left = on_axis ? 0.0 : a - 0.5, right = a + 0.5;
  const double bottom = b - 0.5, top = b + 0.5;
  const double full_until = std::clamp(where_height_is(top, radius), left, right);
  const double until = std::clamp(where_height_is(bottom, radius), left, right);
  Moments sum;
  add_rectangle(sum, left, full_until, bottom, top);
  if (until > full_until) add_cap(sum, full_until, until, bottom, radius);
  if (!(sum.area > 0.0)) return {};
  // Rounding must not move the centroid of a sliver out of its cell.
  const double x = on_axis ? 0.0 : std::clamp(sum.x / sum.area, left, right);
  return {on_axis ? 2.0 * sum.area : sum.area, {x, std::clamp(sum.y / sum.area, bottom, top)}};
}

}  // namespace hackle
