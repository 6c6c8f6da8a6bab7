// SPDX-License-Identifier: MIT
// The user's options for a run file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/described.hpp"
#include "lattice/lattice.hpp"
#include "scene/shape.hpp"
#include "store/record_contents.hpp"

namespace hackle {

struct RecordOptions {
  std::optional<double> every{};  // simulated seconds between records, less than a step is a step;
  std::optional<int> steps{};     // or steps between them
  std::vector<std::string> fields{};  // of recordable_fields; empty: the standard ones
  Region region{};                    // whose nodes are recorded
  int coarsen = 1;                    // every n-th node along x and y
  bool exact = false;                 // with the state to the last bit
};

inline constexpr int max_coarsening = 1000;

template <>
inline constexpr auto description_of<RecordOptions> = describe_noun(
    "record", "record",
    member("every", &RecordOptions::every,
           {.unit = "s",
            .range = above(0.0),
            .alternative = true,
            .sentence = "Simulated time between records; less than a step means every step."}),
    member("steps", &RecordOptions::steps,
           {.range = between(1, 1e9),
            .alternative = true,
            .sentence = "Steps between records, instead of the time."}),
    member("fields", &RecordOptions::fields,
           {.range = at_least(1),
            .fallback = "what pictures need",
            .sentence =
                "Names of what is recorded: \"damage\", \"displacement\", \"velocity\", \"bonds\" "
                "and any other field of pictures. Without displacement, velocity and bonds no "
                "pictures can be made of the file."}),
    member("region", &RecordOptions::region, about_region),
    member("coarsen", &RecordOptions::coarsen,
           {.range = between(1, max_coarsening),
            .fallback = "1",
            .sentence = "Records every n-th node along x and y."}),
    member("exact", &RecordOptions::exact,
           {.fallback = "false",
            .sentence = "Records the state to the last bit too: load goes on from any record. "
                        "Displacement and velocity are then in double precision."}));

// Returns what records hold with these options. Throws Error (refused) for a field that does not
// exist or cannot be had, for a region without a node, and for a part of the plate where all of it
// is asked for.
RecordContents contents_of(const RecordOptions& options, const Lattice& lattice);

// Returns the time between records, s. Throws Error (refused) unless one of the two is given.
double interval_of(const RecordOptions& options, double dt);

}  // namespace hackle
