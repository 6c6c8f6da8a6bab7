// SPDX-License-Identifier: MIT
// How the results of a script depend on its numerics, one by one: the horizon with m fixed, m with
// the horizon fixed, and the step.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/described.hpp"
#include "study/case_runner.hpp"
#include "study/observed_order.hpp"
#include "study/quantity.hpp"
#include "study/scene_numerics.hpp"

namespace hackle {

// What is refined. delta: spacing and horizon together, m fixed; m: the spacing, horizon fixed.
enum class RefinedBy { delta, m, step };
template <>
inline constexpr auto enum_names<RefinedBy> = std::to_array<std::string_view>({"delta", "m",
                                                                               "step"});

struct ConvergenceOptions {
  std::vector<QuantityRow> quantities;  // empty: all
  std::vector<RefinedBy> axes{RefinedBy::delta, RefinedBy::m, RefinedBy::step};
  int levels = 3;       // of delta and step, 2 to 8: one coarser than written, the rest finer
  double ratio = 2.0;   // of delta from level to level, above 1
  double budget = 600;  // s of CPU time that a level may be expected to take; more is left out
  // Options that the script declares: where it has its own spacing and horizon, which may be used
  // for more than the lattice, they are set too.
  std::set<std::string> declared;
};

struct Level {
  Outcome outcome;
  double size = 0.0;     // delta: horizon, m; m: spacing, m; step: time step, s
  std::string name;      // "2 mm", "m = 4", "105 ns"
  double spacing = 0.0;  // m
  double dt = 0.0;       // s
};

struct LeftOutLevel {
  std::string name;
  double expected = 0.0;  // s of CPU time
};

struct QuantityConvergence {
  QuantityRow row;
  std::vector<QuantityValue> values;  // of the levels
  // How far each is from that of the finest level; none if it was not found.
  std::vector<std::optional<double>> distances;
  double resolution = 0.0;  // what the finest level can tell apart, in the unit of the row
  ObservedOrder order;
  std::optional<double> limit;     // of a number that converges, after Richardson
  std::optional<Vec2> place;       // the same of a place, m
  std::optional<double> gci;       // uncertainty; of a number as a share of the finest value
  std::optional<double> exponent;  // of a number that diverges: it goes with size^exponent
};

struct ConvergenceAxis {
  RefinedBy by = RefinedBy::delta;
  std::vector<Level> levels;  // from coarse to fine; those that finished
  std::vector<LeftOutLevel> left_out;
  std::vector<std::string> failed;  // "2 mm: reason"
  std::vector<QuantityConvergence> quantities;
  std::vector<QuantityRow> absent;  // found at no level
};

struct ConvergenceStudy {
  Outcome written;  // the script as written
  SceneNumerics numerics;
  double sample_at = 0.0;  // s: 0.8 of the time of its first broken bond, or half its duration
  std::vector<ConvergenceAxis> axes;
  int runs = 0;  // that were not kept from earlier
};

// Throws what CaseRunner throws, and Error (run_failed) if the script as written fails.
ConvergenceStudy convergence(CaseRunner& runner, const ConvergenceOptions& options);

// Returns what the levels tell of a quantity; nothing if none found it. Needs no names of
// the levels.
std::optional<QuantityConvergence> judged(const std::vector<Level>& levels, const QuantityRow& row);

// "horizon", "spacing", "step": what an axis makes smaller.
std::string_view refined_name(RefinedBy by);

// The error of a number is a share of it, unless that is one itself; of all else it has the unit of
// the quantity.
bool has_relative_error(const QuantityRow& row);

// Paths and fields have no value to tell: what counts is how far they are from the finest.
bool is_by_distance(const QuantityRow& row);

}  // namespace hackle
