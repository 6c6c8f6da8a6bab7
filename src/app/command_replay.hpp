// SPDX-License-Identifier: MIT
// hackle replay RUN.h5
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "output/run/proof.hpp"

namespace hackle {

struct ReplayRequest {
  std::filesystem::path run;
  Execution execution;
  bool json = false;
  bool quiet = false;
};

// Says in a few lines what was compared, and the first difference.
std::string text_of(const Proof& proof, const std::string& run);
// The same for machines.
nlohmann::ordered_json to_json(const Proof& proof, const std::string& run);

// Computes a run again from its file. Returns the exit code: 1 if something differs, 4 if a record
// cannot be computed from what the file says.
int command_replay(const ReplayRequest& request);

}  // namespace hackle
