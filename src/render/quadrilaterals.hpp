// SPDX-License-Identifier: MIT
// Blocks of cells as what is drawn of them: flat parts of a plate in one piece.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/cell_mesh.hpp"

namespace hackle {

// A corner of a quadrilateral: where it is seen, which point of the blocks that is, and the blocks
// that the quadrilateral shows, from the first column and row up to the last.
struct MeshVertex {
  float x = 0.0F, y = 0.0F;                                    // Camera::share
  float column = 0.0F, row = 0.0F;                             // in blocks
  float left = 0.0F, bottom = 0.0F, right = 0.0F, top = 0.0F;  // in blocks
};

// Four for each quadrilateral, in the order of corners(). Blocks with a value of nan are left out.
// Blocks that share their corners become one quadrilateral, as large as `tolerance` allows: how far
// it may be from any of their corners, Camera::share. Drawing takes time for each of them, and
// nearly all of a plate is smooth. They are larger than they are by the tolerance, so that no
// background is seen between neighbours of different size.
std::vector<MeshVertex> quadrilaterals(const Blocks& blocks, std::span<const float> corners,
                                       std::span<const float> values, const Vec2& tolerance);

// Two triangles for each of so many quadrilaterals, as numbers of vertices.
std::vector<std::uint32_t> triangles(std::size_t quadrilaterals);

}  // namespace hackle
