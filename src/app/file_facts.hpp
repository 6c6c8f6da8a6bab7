// SPDX-License-Identifier: MIT
// What a run file, a checkpoint or a movie of Hackle is, and how to go on with it.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace hackle {

struct FileFacts {              // NOLINT(bugprone-exception-escape): of the JSON library
  nlohmann::ordered_json json;  // README.md, "--json"
  std::vector<std::pair<std::string, std::string>> lines;  // for a person: name and text
  std::vector<std::string> next;                           // commands, or lines of a script
};

// Throws Error (files) for a file that is missing, damaged or none of ours, Error (interrupted).
FileFacts facts_of_file(const std::filesystem::path& path);

}  // namespace hackle
