// SPDX-License-Identifier: MIT
// Where a plate is, whatever its lattice: for pictures of many runs of it.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "lattice/lattice.hpp"

namespace hackle {

struct SampledPlate {
  double width = 0.0, height = 0.0;  // m, of the lattice
  // From the lower row up, a letter for each of equal boxes: '#' where its middle has material, '.'
  // where it has none.
  std::vector<std::string> rows;
};

// Takes at most 240 boxes along the longer side, as many as there are nodes if that is less.
SampledPlate sampled_plate(const Lattice& lattice);

// Returns {"width_m":..,"height_m":..,"rows":["##.#",..]}.
nlohmann::ordered_json to_json(const SampledPlate& plate);

}  // namespace hackle
