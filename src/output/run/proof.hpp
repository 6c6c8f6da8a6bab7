// SPDX-License-Identifier: MIT
// The proof of a run file: the run is computed again from what the file says, and compared record
// by record.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "base/progress.hpp"
#include "solver/simulation.hpp"

namespace hackle {

// The first thing that is not as it was recorded.
struct Discrepancy {
  std::size_t record = 0;
  double time = 0.0;  // s
  std::int64_t step = 0;
  std::string quantity;            // of the file, "broken"; "state_hash" where all else is equal
  std::optional<Vec2> node;        // its column and row; none for what belongs to no node
  Vec2 place{0, 0};                // m, of the node
  std::string detail;              // which bond, component or body it is; may be empty
  std::string recorded, computed;  // the values
};

struct Proof {
  std::size_t records = 0;  // in the file
  std::size_t compared =
      0;                    // of them; all but the last of these are equal if there is a difference
  bool has_hashes = false;  // a file of format 2 has none: then only fields are compared
  bool exact_hash = true;   // whether the hash of the record that differs is equal
  std::optional<Discrepancy> difference;
  std::string stopped;  // why record `compared` cannot be computed; "" if all were
};

// Starts from the exact state in the first record (in a file without, from the scene) and does
// again what the journals of the file say: steps, exchanged loads, equilibria, slow loading. Every
// dataset of every record must have the same bits, and so must the state where its hash is
// recorded; ends at the first difference. Threads and instruction set may be others. Throws Error
// (files) for a file that is damaged or whose lattice cannot be built again, Error (refused) for
// loads that are functions of a script, naming them, Error (interrupted) on Ctrl-C.
Proof prove(const std::filesystem::path& run_file, const Execution& execution, Talk talk);

}  // namespace hackle
