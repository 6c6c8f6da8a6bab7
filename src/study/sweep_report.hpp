// SPDX-License-Identifier: MIT
// What a sweep says to a person and to other programs.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "study/sweep.hpp"
#include "study/table.hpp"

namespace hackle {

// A row per run: its settings, its quantities, wall time. Quantities that no run found, paths, and
// what does not fit into the columns of a terminal are left out; `columns` 0: all fit.
Table table_of(const Sweep& sweep, std::size_t columns = 0);

// A row per run in SI units, with two columns for a place; paths are in the JSON alone.
Table numbers_of(const Sweep& sweep);

// The table, failures, and the threshold.
std::string text_of(const Sweep& sweep, std::size_t columns);

// Says at what value the condition changes, or why none was found.
std::string text_of(const Threshold& threshold);

// {"schema":1,"kind":"sweep","runs":[{"settings":{},"quantities":{},"wall_s":..}],"threshold":{}}
nlohmann::ordered_json to_json(const Sweep& sweep);

}  // namespace hackle
