// SPDX-License-Identifier: MIT
#include "console/language/plate_memory.hpp"

#include <variant>

namespace hackle {
namespace {

template <class T>
std::size_t bytes_of(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

struct BytesOfShape {
  std::size_t operator()(const Polygon& polygon) const { return bytes_of(polygon.points); }
  std::size_t operator()(const Bitmap& bitmap) const { return bytes_of(bitmap.inside); }
  template <class Other>
  std::size_t operator()(const Other&) const {
    return 0;
  }
};

// Returns the memory of a part beyond its own size.
std::size_t beyond(const Shape& shape) {
  return std::visit(BytesOfShape{}, shape);
}
std::size_t beyond(const Crack& crack) {
  return bytes_of(crack.points);
}
std::size_t beyond(const Outline& outline) {
  std::size_t bytes = bytes_of(outline.areas);
  for (const Shape& area : outline.areas) bytes += beyond(area);
  return bytes;
}
template <class Part>
std::size_t beyond(const Part& part) {
  std::size_t bytes = 0;
  if constexpr (requires { part.shape; }) bytes += beyond(part.shape);
  if constexpr (requires { *part.region; })
    if (part.region) bytes += beyond(*part.region);
  if constexpr (requires { part.amplitude; }) bytes += bytes_of(part.amplitude.points());
  return bytes;
}

template <class Part>
std::size_t added(const std::vector<Part>& parts, std::size_t& counted) {
  std::size_t bytes = 0;
  for (; counted < parts.size(); ++counted) bytes += sizeof(Part) + beyond(parts[counted]);
  return bytes;
}

}  // namespace

std::size_t PlateMemory::grown(const Plate& plate) {
  const Loads& loads = plate.loads;
  std::size_t bytes = added(plate.cutouts, counted_[0]) + added(plate.inclusions, counted_[1]) +
                      added(plate.cracks, counted_[2]) + added(plate.no_fail, counted_[3]) +
                      added(plate.initial_conditions, counted_[4]) +
                      added(loads.tractions, counted_[5]) + added(loads.pressures, counted_[6]) +
                      added(loads.body_forces, counted_[7]) + added(loads.supports, counted_[8]) +
                      added(loads.thermal_loads, counted_[9]) + added(plate.outlines, counted_[10]);
  total_ += bytes;
  return bytes;
}

}  // namespace hackle
