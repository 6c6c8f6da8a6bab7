// SPDX-License-Identifier: MIT
// A field of a plate at one moment, kept as it was: it may be asked when the plate has gone on.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lattice/grid.hpp"
#include "scene/shape.hpp"
#include "solver/view.hpp"

namespace hackle {

class NodeValues {
 public:
  // Of a field of pictures (scalar.hpp). Throws Error (refused) for an unknown name, with the
  // nearest.
  NodeValues(std::string_view field, const View& view);

  // A value at the place of a node, m.
  struct Place {
    double value = 0.0;
    Vec2 place{0, 0};
  };
  // Return the largest and the smallest value; of equal ones that of the lowest node, and of these
  // the leftmost.
  Place max() const;
  Place min() const;
  // Returns the mean over the nodes of a region, or of the plate; nothing without a node.
  std::optional<double> mean(const Region& region = {}) const;
  // Returns the value between nodes, not across open cracks (between_nodes.hpp); nothing off the
  // plate or in a hole.
  std::optional<double> at(const Vec2& place) const;

  // Calls visit(i, j, value) for every node that is not in a hole, row by row from the lower left.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (int j = 0; j < grid_.ny; ++j)
      for (int i = 0; i < grid_.nx; ++i)
        if (is_there(i, j)) visit(i, j, static_cast<double>(values_[grid_.index(i, j)]));
  }

  const std::string& name() const { return name_; }
  const std::string& unit() const { return unit_; }  // SI
  double time() const { return time_; }              // s
  const Grid& grid() const { return grid_; }
  bool is_there(int i, int j) const { return there_.empty() || there_[grid_.index(i, j)] != 0; }

 private:
  bool joined(int i, int j, int column, int row) const;

  std::string name_, unit_;
  double time_;
  Grid grid_;
  std::vector<float> values_;        // by Grid::index, here as below
  std::vector<std::uint8_t> links_;  // see links.hpp
  std::vector<std::uint8_t> there_;  // 0 in a hole; empty without holes
};

}  // namespace hackle
