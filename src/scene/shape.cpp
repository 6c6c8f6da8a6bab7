// SPDX-License-Identifier: MIT
#include "scene/shape.hpp"

#include <type_traits>

namespace hackle {

Box bounds(const Shape& shape) {
  return std::visit([](const auto& s) { return bounds_of(s); }, shape);
}

Shape transformed(const Shape& shape, const Vec2& origin, double factor) {
  return std::visit([&](const auto& s) -> Shape { return moved(s, origin, factor); }, shape);
}

bool is_inside(const Shape& shape, const Vec2& point, double tie) {
  return std::visit([&](const auto& s) { return lies_inside(s, point, tie); }, shape);
}

bool covers(const Shape& shape, const Vec2& point, double tie) {
  return std::visit([&](const auto& s) { return covers_point(s, point, tie); }, shape);
}

bool cuts(const Shape& shape, const Segment& segment, double tie) {
  return std::visit([&](const auto& s) { return cuts_segment(s, segment, tie); }, shape);
}

void add_crossings(const Shape& shape, const Segment& segment, double tie,
                   std::vector<double>& crossings) {
  std::visit([&](const auto& s) { add_crossings_of(s, segment, tie, crossings); }, shape);
}

bool may_cut(const Shape& shape, const Box& box, double tie) {
  return std::visit([&](const auto& s) { return may_cut_in(s, box, tie); }, shape);
}

Shape rectangle(const Vec2& min, const Vec2& max) {
  return Polygon{{min, {max.x(), min.y()}, max, {min.x(), max.y()}}};
}

std::string kind_of(const Shape& shape) {
  return std::visit(
      [](const auto& kind) {
        return std::string(description_of<std::remove_cvref_t<decltype(kind)>>.noun);
      },
      shape);
}

void check(const Shape& shape, const std::string& who, Problems& problems) {
  std::visit([&](const auto& s) { check_shape(s, who, problems); }, shape);
}

}  // namespace hackle
