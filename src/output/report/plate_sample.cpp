// SPDX-License-Identifier: MIT
#include "output/report/plate_sample.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

namespace hackle {
namespace {

constexpr int max_boxes = 240;

// The node at the middle of a box.
int node_at(int box, int boxes, int nodes) {
  return std::min(nodes - 1, static_cast<int>((box + 0.5) * nodes / boxes));
}

}  // namespace

SampledPlate sampled_plate(const Lattice& lattice) {
  const Grid& grid = lattice.grid;
  const double share = std::min(1.0, static_cast<double>(max_boxes) / std::max(grid.nx, grid.ny));
  const int columns = std::max(1, static_cast<int>(std::lround(share * grid.nx)));
  const int rows = std::max(1, static_cast<int>(std::lround(share * grid.ny)));
  SampledPlate plate{grid.nx * grid.dx, grid.ny * grid.dx, {}};
  for (int row = 0; row < rows; ++row) {
    std::string& line = plate.rows.emplace_back();
    for (int column = 0; column < columns; ++column) {
      const int i = node_at(column, columns, grid.nx), j = node_at(row, rows, grid.ny);
      line += lattice.is_void(i, j) ? '.' : '#';
    }
  }
  return plate;
}

nlohmann::ordered_json to_json(const SampledPlate& plate) {
  return {{"width_m", plate.width}, {"height_m", plate.height}, {"rows", plate.rows}};
}

}  // namespace hackle
