// SPDX-License-Identifier: MIT
// How far the cracks of a plate, or of a region of it, have advanced.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "measure/fork.hpp"
#include "scene/shape.hpp"
#include "solver/view.hpp"

namespace hackle {

Box everywhere();

// The nodes in a region that lie on a crack.
struct Cracks {
  std::int64_t nodes = 0;
  Box box{};                   // m, their bounding box; if nodes > 0
  int bands = 0;               // the largest number of cracks in one column of nodes,
                               // separated by more than about a horizon
  std::optional<double> fork;  // m, the first fork from the left (fork.hpp)
};

// Without a region, examines the whole plate.
Cracks cracks(const View& view, const Box& area = everywhere());
// Examines given nodes on cracks, of which `at_start` were on one before anything broke. The
// horizon is m spacings.
Cracks cracks(Nodes nodes, Nodes at_start, const Grid& grid, double m, const Box& area);

// Returns the position, m, of the node on a crack that lies farthest along `direction`; the mean of
// several within half a spacing. Returns nothing if no node lies on a crack.
std::optional<Vec2> foremost(const Field& damage, const Grid& grid, const Vec2& direction);

}  // namespace hackle
