// SPDX-License-Identifier: MIT
// How far the cracks of a plate, or of an area of it, have come, and which parts still hang
// together.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "measure/fork.hpp"
#include "scene/shape.hpp"
#include "solver/view.hpp"

namespace hackle {

Box everywhere();

// The nodes on a crack that lie in an area.
struct Cracks {
  std::int64_t nodes = 0;
  Box box{};                   // m, their bounding box; when nodes > 0
  int bands = 0;               // the most cracks side by side in one column of nodes, those apart
                               // that lie more than about a horizon from each other
  std::optional<double> fork;  // m, the first place from the left where one forks (fork.hpp)
};

// Of the whole plate, without an area.
Cracks cracks(const View& view, const Box& area = everywhere());
// The same for given nodes on cracks, of which `at_start` lay on one before anything broke. The
// horizon is m spacings.
Cracks cracks(Nodes nodes, Nodes at_start, const Grid& grid, double m, const Box& area);

// The place, m, of the node on a crack that lies farthest along `direction`; the middle of several
// that lie within half a spacing. Nothing when no node lies on a crack.
std::optional<Vec2> foremost(const Field& damage, const Grid& grid, const Vec2& direction);

// The number of nodes of each part that bonds hold together, the largest first; a node without
// bonds is no part.
std::vector<int> fragment_sizes(const View& view);

}  // namespace hackle
