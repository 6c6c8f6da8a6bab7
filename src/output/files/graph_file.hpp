// SPDX-License-Identifier: MIT
// The graph of cracks as JSON and as tables.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "measure/crack_graph.hpp"

namespace hackle {

// The tables of a graph, in the order of this enumeration.
enum class GraphTable { paths, tips, events };

// Returns the array "events" documented in README.md, "--json"; `rayleigh` is the speed of Rayleigh
// waves, m/s. What is not known is left out.
nlohmann::ordered_json to_json(const std::vector<CrackEvent>& events, double rayleigh);
// Returns the time, the speed of Rayleigh waves, cracks, tips and events.
nlohmann::ordered_json to_json(const CrackGraph& graph);
// Returns CSV in SI with the units in its head: a row for each point of a path, tip or event; cells
// are empty where nothing is known.
std::string to_csv(const CrackGraph& graph, GraphTable table);

// Refuses every ending but .json and .csv. `who` names the calling function.
void check_graph_ending(const std::string& who, const std::filesystem::path& path);
// Writes all of it as .json, or one of its tables as .csv. Throws Error (files).
void write_graph(const CrackGraph& graph, GraphTable table, const std::filesystem::path& path);

}  // namespace hackle
