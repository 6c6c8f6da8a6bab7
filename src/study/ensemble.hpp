// SPDX-License-Identifier: MIT
// Many runs of a scene that differ in nothing that it determines: how long they agree, and what can
// be said of them after that. A branching crack at high load is chaotic: a change in the last digit
// moves its branches, and only statistics of many runs mean anything.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/case_runner.hpp"
#include "study/crack_frequency.hpp"
#include "study/quantity.hpp"
#include "study/scene_numerics.hpp"
#include "study/statistics.hpp"
#include "study/timed_paths.hpp"

namespace hackle {

// What differs between the runs.
enum class Change {
  stiffness,    // Young's modulus of the plate, by a share that nobody knows it to
  strength,     // scattered from node to node, normal, with another seed in each run
  own_scatter,  // the seed of the scatter that the plate has
};

struct EnsembleOptions {
  int runs = 32;  // at least 2
  Change change = Change::stiffness;
  // Of the stiffness, the largest relative change; 0: run k has its last bits changed by k times
  // last_bit(). Of the strength, the relative standard deviation.
  double size = 0.0;
  std::optional<double> within;         // m, of paths that agree; none: one horizon
  std::vector<QuantityRow> quantities;  // numbers and counts; none: ensemble_quantities()
};

struct QuantityStatistic {
  QuantityRow row;
  std::vector<std::optional<double>> values;  // of each run; none if it did not find any
  Statistic statistic;                        // of those found

  // Whether one run tells it: all find it, and it deviates by less than 1 %.
  bool is_settled() const;
};

struct Ensemble {
  Change change = Change::stiffness;
  double size = 0.0;  // of the change, the largest if the last bits are changed
  bool of_bits = false;
  SceneNumerics scene;
  double within = 0.0;                // m
  std::vector<Outcome> runs;          // those that finished
  std::vector<Outcome> failed;        // and those that did not
  std::vector<TimedPaths> paths;      // of the runs
  std::optional<TimedPoint> parting;  // where and when two runs first differ; none: they never do
  double apart = 0.0;                 // m, the largest distance between two runs at the end
  std::vector<Vec2> median, largest;  // {s, m}: distance of the runs from the first, over time
  std::vector<QuantityStatistic> quantities;
  CrackFrequency frequency;

  bool has_cracks() const;
  // Whether runs differ though their inputs are the same for all that is known of them.
  bool is_chaotic() const { return change == Change::stiffness && size <= max_unknown && parting; }
  static constexpr double max_unknown = 1e-3;
};

// Returns the numbers and counts that an ensemble tells unless asked for others.
std::vector<QuantityRow> ensemble_quantities();

// Runs the script. Throws what CaseRunner throws, and Error (run_failed) if fewer than two runs
// finish, or the plate lacks a scatter of its own that was asked for.
Ensemble ensemble(CaseRunner& runner, const EnsembleOptions& options);

// The same of runs that are there already, the first of them of the script as written.
Ensemble ensemble_of(const SceneNumerics& scene, const EnsembleOptions& options,
                     std::vector<Outcome> runs);

}  // namespace hackle
