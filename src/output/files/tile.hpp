// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "store/recording.hpp"

namespace hackle {

// One of several recorded runs.
struct Tile {
  std::shared_ptr<Recording> recording;
  std::string title;  // may be empty
};
using Tiles = std::vector<Tile>;

}  // namespace hackle
