// SPDX-License-Identifier: MIT
// The choices of a scene that trade speed for accuracy, and the values worth trying.
#pragma once

#include <string>
#include <vector>

#include "study/case.hpp"
#include "study/scene_numerics.hpp"

namespace hackle {

struct TradeAxis {
  std::string name;              // "spacing"
  std::vector<Settings> values;  // other than what the script has
  bool of_lattice = false;       // sets spacing and horizon: excludes the other axes that do
  bool exact_by_itself = false;  // only arithmetic and step: combines with every lattice
  bool of_model = false;         // changes what is computed: shown, never recommended

  bool has(const Settings& settings) const;  // among its values
};

// Returns them for a scene with these numerics.
std::vector<TradeAxis> trade_axes(const SceneNumerics& scene);

// Returns settings finer in every respect, whose run costs at most about `most` times that of the
// scene; the first that the scene allows is the reference.
std::vector<Settings> reference_settings(const SceneNumerics& scene, double most);

}  // namespace hackle
