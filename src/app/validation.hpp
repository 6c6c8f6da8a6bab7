// SPDX-License-Identifier: MIT
// Ready-made scripts that say what they should give (expect { ... }), and what they give.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "output/report/expectation.hpp"
#include "solver/moving_plate.hpp"

namespace hackle {

struct ValidationScript {
  std::string name;  // "borden"
  std::filesystem::path path;
};

// What became of one script.
struct Validated {
  ValidationScript script;
  std::string title;                // the first sentence of its header
  std::string place;                // below the data of Hackle: "scripts/samples/hole.lua"
  std::vector<Expectation> checks;  // at least one
  std::vector<std::filesystem::path> pictures;
  double seconds = 0.0;  // wall time
};

// Returns the scripts that ship with Hackle and expect something, in the order of the table; if
// `quick`, those whose header names hackle validate --quick. `names` are names of such scripts, or
// beginnings of them, or .lua files; none: all. Throws Error (usage) for a name that fits none, and
// Error (files).
std::vector<ValidationScript> validation_scripts(std::span<const std::string> names, bool quick);

// Runs a script, with its files in `folder`; `quick` sets its option of that name, if it has one. A
// script that fails gives a failed check with the reason. Throws Error (interrupted).
Validated validated(const ValidationScript& script, bool quick, const std::filesystem::path& folder,
                    const Execution& execution);

// How many of them have this verdict.
std::size_t count(std::span<const Validated> all, Verdict verdict);

}  // namespace hackle
