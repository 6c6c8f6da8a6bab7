// SPDX-License-Identifier: MIT
// The files that a study leaves in its folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "render/diagram/diagram.hpp"
#include "study/table.hpp"

namespace hackle {

// What a study has found. `name` is that of its files: "trade" gives trade.csv, trade.json and
// trade.png.
struct StudyFindings {
  std::string name;
  std::string text;                        // for a person
  Table table;                             // in SI
  std::vector<Diagram> diagrams;           // the first is trade.png, others are trade-2.png, ...
  std::vector<std::string> diagram_names;  // ... unless they have names: "delta-error"
};

// Returns the text of the JSON file.
std::string findings_text(const nlohmann::ordered_json& json);

// Writes the files, the JSON file last, in turn with other processes, and returns them. Throws
// Error (files, interrupted).
std::vector<std::filesystem::path> write_findings(const StudyFindings& findings,
                                                  const nlohmann::ordered_json& json,
                                                  const std::filesystem::path& folder);

}  // namespace hackle
