// SPDX-License-Identifier: MIT
// The cells of the envelope of stability: scenes at the extremes, as data. A family is a script in
// scripts/envelope, which also checks its own result; a cell is the script with values of its
// options.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "study/case.hpp"

namespace hackle {

// How a cell may end. A right result passes every check of its script.
enum class Demand {
  right,    // only so
  refused,  // before the run
  stopped,  // cleanly, with cause, time and place
  unlike,   // refused or stopped: it makes no sense
  any,      // in one of the three ways
};

struct EnvelopeFamily {
  std::string_view name;      // of the script
  std::string_view sentence;  // what is extreme in it
};

struct EnvelopeCell {
  std::string_view family;
  std::string name;  // "share=0.95 m=8"
  Settings settings;
  Demand demand = Demand::right;
  bool heavy = false;  // runs alone, with all threads, and not in the quick sample
  bool quick = false;  // in the quick sample
  int row = 0;         // cells that vary the same options have the same
};

// Returns all families, in the order of the map.
std::span<const EnvelopeFamily> envelope_families();

// Returns the cells of these families, of all if none is named; only the quick sample if `quick`:
// of every row of the table the first, the last and some between. Throws Error (usage) with the
// nearest name for a family that is none.
std::vector<EnvelopeCell> envelope_cells(const std::vector<std::string>& families, bool quick);

// Returns the settings of "share=0.2|0.4 m=4": every combination of the alternatives, the last word
// varying fastest, with its name.
std::vector<EnvelopeCell> expanded(std::string_view family, std::string_view words);

}  // namespace hackle
