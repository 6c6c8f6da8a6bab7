// SPDX-License-Identifier: MIT
// The paths of cracks from node to node, found among the nodes on them: what is on a crack grows
// together in the order in which it came, and the farthest nodes are followed back to where their
// crack began. Ridge_line.hpp moves the paths to the middle of the damage.
#pragma once

#include <cstddef>
#include <vector>

#include "measure/crack_forest.hpp"

namespace hackle {

struct SkeletonPath {
  std::vector<std::size_t> nodes;  // by Grid::index, from the origin to the end
  int parent = -1;                 // the path on which it begins; -1: none
  std::size_t leaves = 0;          // its first node among those of the parent
};

struct CrackSkeleton {
  std::vector<SkeletonPath> paths;  // each behind its parent
  std::vector<Meeting> meetings;
};

// A path counts if it is a ridge of damage and continues for a horizon beyond where it is a horizon
// away from all others; cracks of the scene always do. So specks and clouds of damage have none,
// and neither have frayed sides.
CrackSkeleton skeleton(const CrackGrowth& growth);

}  // namespace hackle
