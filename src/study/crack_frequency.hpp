// SPDX-License-Identifier: MIT
// How often each point of a plate was cracked, over many runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lattice/grid.hpp"
#include "study/timed_paths.hpp"

namespace hackle {

struct CrackFrequency {
  Grid grid;                               // of the map, not of a simulation
  std::vector<float> share;                // of the runs, by Grid::index; nan: no material
  std::vector<std::vector<Vec2>> initial;  // m, cracks of the scene
};

// Returns in which share of the runs a path has grown within `radius`, m, of each point. `plate` is
// what one of them tells under that key.
CrackFrequency crack_frequency(const std::vector<TimedPaths>& runs,
                               const nlohmann::ordered_json& plate, double radius);

// Writes it as a PNG, with a colour bar. Throws Error (files), Error (run_failed) without a GL
// context.
void write_picture(const CrackFrequency& frequency, const std::string& title,
                   const std::filesystem::path& path);

}  // namespace hackle
