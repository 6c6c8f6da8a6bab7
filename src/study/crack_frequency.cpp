// SPDX-License-Identifier: MIT
#include "study/crack_frequency.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/plate_painter.hpp"
#include "render/png.hpp"
#include "study/path_distance.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

constexpr double min_cells = 240.0, max_cells = 600.0;  // along the longer side
constexpr double cells_a_radius = 3.0;

Grid grid_of(const Json& plate, double radius) {
  const double width = plate["width_m"].get<double>(), height = plate["height_m"].get<double>();
  const double longer = std::max(width, height);
  const double cell = longer / std::clamp(cells_a_radius * longer / radius, min_cells, max_cells);
  return {std::max(1, static_cast<int>(std::lround(width / cell))),
          std::max(1, static_cast<int>(std::lround(height / cell))), cell,
          Vec2(0.5 * width, 0.5 * height)};
}

bool has_material(const Json& rows, const Grid& grid, int i, int j) {
  const auto at = [](int cell, int cells, std::size_t boxes) {
    return std::min(boxes - 1,
                    static_cast<std::size_t>((cell + 0.5) / cells * static_cast<double>(boxes)));
  };
  const auto& row = rows[at(j, grid.ny, rows.size())].get_ref<const std::string&>();
  return row[at(i, grid.nx, row.size())] == '#';
}

// Marks the cells that a piece of a path passes within the radius.
void mark(std::vector<char>& cracked, const Grid& grid, const Vec2& a, const Vec2& b,
          double radius) {
  const Vec2 corner = grid.position(0, 0);
  const auto cell_of = [&](double place, double first, int cells) {
    return std::clamp(static_cast<int>(std::lround((place - first) / grid.dx)), 0, cells - 1);
  };
  const Vec2 low = a.cwiseMin(b) - Vec2(radius, radius),
             high = a.cwiseMax(b) + Vec2(radius, radius);
  const int right = cell_of(high.x(), corner.x(), grid.nx);
  const int top = cell_of(high.y(), corner.y(), grid.ny);
  for (int j = cell_of(low.y(), corner.y(), grid.ny); j <= top; ++j)
    for (int i = cell_of(low.x(), corner.x(), grid.nx); i <= right; ++i)
      if (distance_to_segment(grid.position(i, j), a, b) <= radius) cracked[grid.index(i, j)] = 1;
}

std::vector<char> cracked_by(const TimedPaths& paths, const Grid& grid, double radius) {
  std::vector<char> cracked(grid.nodes());
  for (const auto& line : paths.grown)
    for (std::size_t k = 0; k < line.size(); ++k)
      mark(cracked, grid, line[k].place, line[std::min(k + 1, line.size() - 1)].place, radius);
  return cracked;
}

}  // namespace

CrackFrequency crack_frequency(const std::vector<TimedPaths>& runs, const Json& plate,
                               double radius) {
  CrackFrequency map{.grid = grid_of(plate, radius), .share = {}, .initial = {}};
  std::vector<int> times(map.grid.nodes());
  for (const TimedPaths& paths : runs) {
    const std::vector<char> cracked = cracked_by(paths, map.grid, radius);
    for (std::size_t k = 0; k < times.size(); ++k) times[k] += cracked[k];
  }
  if (!runs.empty()) map.initial = runs.front().initial;
  map.share.assign(times.size(), std::numeric_limits<float>::quiet_NaN());
  for (int j = 0; j < map.grid.ny; ++j)
    for (int i = 0; i < map.grid.nx; ++i)
      if (has_material(plate["rows"], map.grid, i, j))
        map.share[map.grid.index(i, j)] = static_cast<float>(times[map.grid.index(i, j)]) /
                                          static_cast<float>(std::max<std::size_t>(1, runs.size()));
  return map;
}

void write_picture(const CrackFrequency& frequency, const std::string& title,
                   const std::filesystem::path& path) {
  PictureStyle style;
  style.grid = frequency.grid;
  style.field = {.colour_map = "inferno",
                 .min = 0.0,
                 .max = 1.0,
                 .label = "share of the runs that cracked here",
                 .unit = ""};
  style.overlay.clock = false;
  style.title = title;
  Shot shot;
  shot.values = frequency.share;
  shot.cracks.paths = frequency.initial;
  write_png(PlatePainter(style).paint(shot), path);
}

}  // namespace hackle
