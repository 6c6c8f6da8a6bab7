// SPDX-License-Identifier: MIT
// What each feature of a scene adds to its time and memory, and that absent ones add nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "study/case_runner.hpp"
#include "study/table.hpp"

namespace hackle {

enum class FeatureKind {
  base,    // the plate without any
  absent,  // said, but with no effect: it must cost nothing
  kernel,  // works bond by bond
  term,    // acts beside the kernel at every step
  output,  // what a run leaves behind
};

struct FeatureRow {
  std::string_view name;  // in scripts/study/feature.lua
  FeatureKind kind = FeatureKind::term;
  std::string_view sentence;
};

// Returns all of them; the first is the base.
std::span<const FeatureRow> feature_rows();

// Returns the rows of these names, all if there is none, with the base first. Throws Error (usage)
// with the nearest name.
std::vector<FeatureRow> features_named(const std::vector<std::string>& names);

// What a run with one feature costs, on one thread.
struct FeatureCost {
  std::string name;
  std::string what;
  double cpu = 0.0;                          // s, of the longer run as a whole
  double start_cpu = 0.0;                    // s, of a run without steps
  double ns_per_node_step = 0.0;             // of CPU time, from two numbers of steps
  std::int64_t bytes = 0;                    // peak, less that of the base
  std::int64_t start_bytes = 0;              // likewise of a run without steps: pages touched
  std::optional<double> instructions;        // per node-step, from two numbers of steps
  std::optional<double> start_instructions;  // of a run without steps
  std::vector<std::string> inside;           // kernel_features of the run
  bool finished = true;
  std::string reason;  // why not
};

struct FeatureOptions {
  int rounds = 3;      // the least time counts
  bool count = false;  // instructions, by valgrind
};

// Measures the rows with scripts/study/feature.lua. The first is taken as the base. Throws what
// CaseRunner throws, and Error (refused) if instructions are to be counted without valgrind.
std::vector<FeatureCost> measure_features(CaseRunner& runner, const std::vector<FeatureRow>& rows,
                                          const FeatureOptions& options);

// Measures a script: as written, without pictures and movies, and what its parts take by its own
// account (terms, kernel, pictures, movies, files). Throws what CaseRunner throws, and Error
// (run_failed).
std::vector<FeatureCost> measure_script(CaseRunner& runner, const FeatureOptions& options);

// Returns the costs for a person, and as a table in SI.
std::string text_of(const std::vector<FeatureCost>& costs);
Table table_of(const std::vector<FeatureCost>& costs);
// Returns {"schema":1,"kind":"features","features":[...]}.
nlohmann::ordered_json to_json(const std::vector<FeatureCost>& costs);

}  // namespace hackle
