// SPDX-License-Identifier: MIT
// What of a stored run goes into the files of other programs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/interrupt.hpp"
#include "measure/field.hpp"
#include "store/stored_run.hpp"

namespace hackle {

// The wishes of a user; at most one of the first two.
struct ExportWishes {
  std::vector<double> times;        // s: the nearest states
  std::optional<double> every;      // s: the states nearest to multiples of it
  bool all_times = false;           // without the others: all states, or only the last
  std::vector<std::string> fields;  // as field_by_name() knows them; none: the standard ones
};

struct ExportChoice {
  std::vector<std::size_t> states;  // of StoredRun::times(), ascending, each once
  std::vector<std::string> fields;
};

// Throws Error (refused) for a field that is unknown or that the plate does not have, and for an
// `every` that is not above 0.
ExportChoice chosen(const StoredRun& run, const ExportWishes& wishes);

// A node of the lattice that is not cut out, by its column and row.
using ExportNode = std::pair<int, int>;
std::vector<ExportNode> export_nodes(const Lattice& lattice);

// Returns the fields of the state that is shown.
std::vector<Field> export_fields(const StoredRun& run, const ExportChoice& choice);

// Calls visit(time in s, fields) for every chosen state. Looks at Ctrl-C in between.
using ShareDone = std::function<void(double)>;
template <class Visit>
void for_each_state(StoredRun& run, const ExportChoice& choice, const ShareDone& done,
                    const Visit& visit) {
  for (std::size_t k = 0; k < choice.states.size(); ++k) {
    throw_if_interrupted();
    done(static_cast<double>(k) / static_cast<double>(choice.states.size()));
    run.show(choice.states[k]);
    visit(run.times()[choice.states[k]], export_fields(run, choice));
  }
}

}  // namespace hackle
