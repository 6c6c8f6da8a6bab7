// SPDX-License-Identifier: MIT
// Displacements at places that do not depend on the lattice, at one moment: what runs of the same
// plate with other numerics can be compared by.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "scene/vec2.hpp"
#include "solver/observer.hpp"
#include "solver/simulation.hpp"

namespace hackle {

struct SampledField {
  double time = 0.0;  // s
  int columns = 0, rows = 0;
  // m, row by row from the lower left corner: at the middles of columns x rows equal boxes of the
  // plate; nothing where there is no plate.
  std::vector<std::optional<Vec2>> displacements;
};

// Takes the sample when a run comes to `time`, s, between steps as Instant does.
class FieldSampler : public Observer {
 public:
  explicit FieldSampler(double time) : time_(time) {}

  // Nothing before that time.
  const std::optional<SampledField>& field() const { return field_; }

  bool due(const Simulation& simulation) override;
  double moment(const Simulation& simulation) override;
  void observe(const Simulation& simulation) override;

 private:
  double time_;
  std::optional<SampledField> field_;
};

// Returns {"time_s":..,"columns":..,"rows":..,"displacements_m":[[ux,uy],null,..]}.
nlohmann::ordered_json to_json(const SampledField& field);

}  // namespace hackle
