// SPDX-License-Identifier: MIT
// What a run file says of itself, without its fields and without a lattice: quick, also of a file
// that was cut off, has no record yet, or has another format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/origin.hpp"

namespace hackle {

// A file that says that it holds more is damaged.
inline constexpr std::int64_t max_records = 1'000'000;

// A dataset, or all of one name in the records.
struct StoredField {
  std::string name;         // "damage"
  std::uint64_t bytes = 0;  // in the file
};

struct RunFacts {
  std::int64_t format = 0;
  std::string version, git_hash, compiler, created;  // "" where an older file lacks it
  Origin origin;
  std::string inputs;  // JSON, see inputs_of()
  bool is_complete = false;
  std::int64_t records = 0;
  std::vector<double> times;  // s, of the records
  std::int64_t last_step = 0;
  std::vector<StoredField> fields;  // in the records, then beside them
};

// Throws Error (files) for what is no run file of Hackle or is damaged, Error (interrupted).
RunFacts facts_of_run(const std::filesystem::path& path);

}  // namespace hackle
