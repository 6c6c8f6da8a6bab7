// SPDX-License-Identifier: MIT
// Turns blocks of cells into the quadrilaterals that are drawn: flat parts of a plate become one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/cell_mesh.hpp"

namespace hackle {

// A corner of a quadrilateral: its position in the picture, its point in blocks, and the range of
// blocks that the quadrilateral shows.
struct MeshVertex {
  float x = 0.0F, y = 0.0F;                                    // Camera::share
  float column = 0.0F, row = 0.0F;                             // in blocks
  float left = 0.0F, bottom = 0.0F, right = 0.0F, top = 0.0F;  // in blocks
};

// Returns four vertices per quadrilateral, in the order of corners(). Blocks with a value of nan
// are left out. Blocks that share corners are merged as far as `tolerance` (Camera::share) allows,
// the largest deviation from any of their corners: drawing takes time for each quadrilateral, and
// most of a plate is smooth. Quadrilaterals are enlarged by the tolerance, so that no background
// shows between neighbours of different size.
std::vector<MeshVertex> quadrilaterals(const Blocks& blocks, std::span<const float> corners,
                                       std::span<const float> values, const Vec2& tolerance);

// Returns two triangles for each of `quadrilaterals` quadrilaterals, as vertex numbers.
std::vector<std::uint32_t> triangles(std::size_t quadrilaterals);

}  // namespace hackle
