// SPDX-License-Identifier: MIT
#include "render/quadrilaterals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hackle {
namespace {

// Finds the largest flat squares of blocks by halving.
class Merger {
 public:
  Merger(const Blocks& blocks, std::span<const float> corners, std::span<const float> values,
         const Vec2& tolerance)
      : blocks_(blocks), corners_(corners), values_(values), tolerance_(tolerance) {}

  std::vector<MeshVertex> all() {
    constexpr int largest = 32;
    for (int row = 0; row < blocks_.rows; row += largest)
      for (int column = 0; column < blocks_.columns; column += largest) add(column, row, largest);
    return std::move(vertices_);
  }

 private:
  // Columns and rows, from the first to the last.
  struct Patch {
    int left, bottom, right, top;
    int columns() const { return right - left + 1; }
    int rows() const { return top - bottom + 1; }
  };

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(blocks_.columns) +
           static_cast<std::size_t>(column);
  }
  Vec2 corner(int column, int row, std::size_t k) const {
    const std::size_t at = 8 * index(column, row) + 2 * k;
    return {corners_[at], corners_[at + 1]};
  }
  bool is_void(int column, int row) const { return std::isnan(values_[index(column, row)]); }
  bool is_near(const Vec2& one, const Vec2& other) const {
    return ((one - other).array().abs() <= tolerance_.array()).all();
  }

  void add(int column, int row, int size) {
    if (column >= blocks_.columns || row >= blocks_.rows) return;
    const Patch patch{column, row, std::min(column + size, blocks_.columns) - 1,
                      std::min(row + size, blocks_.rows) - 1};
    if (size == 1 ? !is_void(column, row) : is_flat(patch)) return emit(patch);
    if (size == 1) return;
    const int half = size / 2;
    for (const int up : {0, half})
      for (const int right : {0, half}) add(column + right, row + up, half);
  }

  // Maps a point of a patch, 0..1 across and up, by its four corners: two triangles.
  static Vec2 inside(const std::array<Vec2, 4>& outer, double across, double up) {
    if (across + up <= 1.0)
      return outer[0] + across * (outer[1] - outer[0]) + up * (outer[2] - outer[0]);
    return outer[3] + (1.0 - across) * (outer[2] - outer[3]) + (1.0 - up) * (outer[1] - outer[3]);
  }

  std::array<Vec2, 4> outer(const Patch& patch) const {
    return {corner(patch.left, patch.bottom, 0), corner(patch.right, patch.bottom, 1),
            corner(patch.left, patch.top, 2), corner(patch.right, patch.top, 3)};
  }

  // A crack shows as a corner far from its place in a flat patch.
  bool is_flat(const Patch& patch) const {
    const std::array<Vec2, 4> ends = outer(patch);
    for (int row = patch.bottom; row <= patch.top; ++row)
      for (int column = patch.left; column <= patch.right; ++column) {
        if (is_void(column, row)) return false;
        for (std::size_t k = 0; k < 4; ++k) {
          const int right = column - patch.left + static_cast<int>(k % 2);
          const int up = row - patch.bottom + static_cast<int>(k / 2);
          const Vec2 there = inside(ends, static_cast<double>(right) / patch.columns(),
                                    static_cast<double>(up) / patch.rows());
          if (!is_near(corner(column, row, k), there)) return false;
        }
      }
    return true;
  }

  void emit(const Patch& patch) {
    const std::array<Vec2, 4> ends = outer(patch);
    const Vec2 middle = 0.25 * (ends[0] + ends[1] + ends[2] + ends[3]);
    const bool is_merged = patch.columns() > 1 || patch.rows() > 1;
    for (std::size_t k = 0; k < 4; ++k) {
      Vec2 place = ends[k];
      if (is_merged) place += tolerance_.cwiseProduct((place - middle).cwiseSign());
      vertices_.push_back({static_cast<float>(place.x()), static_cast<float>(place.y()),
                           static_cast<float>(k % 2 == 0 ? patch.left : patch.right + 1),
                           static_cast<float>(k / 2 == 0 ? patch.bottom : patch.top + 1),
                           static_cast<float>(patch.left), static_cast<float>(patch.bottom),
                           static_cast<float>(patch.right), static_cast<float>(patch.top)});
    }
  }

  const Blocks& blocks_;
  std::span<const float> corners_, values_;
  Vec2 tolerance_;
  std::vector<MeshVertex> vertices_;
};

}  // namespace

std::vector<MeshVertex> quadrilaterals(const Blocks& blocks, std::span<const float> corners,
                                       std::span<const float> values, const Vec2& tolerance) {
  return Merger(blocks, corners, values, tolerance).all();
}

std::vector<std::uint32_t> triangles(std::size_t quadrilaterals) {
  std::vector<std::uint32_t> order;
  order.reserve(6 * quadrilaterals);
  for (std::size_t k = 0; k < quadrilaterals; ++k)
    for (const std::uint32_t corner : {0U, 1U, 2U, 2U, 1U, 3U})
      order.push_back(static_cast<std::uint32_t>(4 * k) + corner);
  return order;
}

}  // namespace hackle
