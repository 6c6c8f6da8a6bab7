// SPDX-License-Identifier: MIT
// A simulation in a file, to the last bit: it goes on from there in another program, on another
// machine, with other threads.
#pragma once

#include <filesystem>
#include <string>

#include "solver/simulation.hpp"
#include "store/inputs_reader.hpp"
#include "store/run_file.hpp"

namespace hackle {

// The file is sealed (sealed_file.hpp): a line that names the format, the size of a head in JSON,
// the head (program, script, inputs, the small members of the state), the continuation, and the
// arrays of the state as they lie in memory (little-endian). It is as large as the state.
struct Checkpoint {
  Origin origin;            // the script that made it
  Inputs inputs;            // with the loads in force; see Inputs for functions
  std::string inputs_text;  // JSON, see store/inputs.hpp
  std::string lattice_hash;
  std::string continuation;  // bytes of whoever kept it: what is needed beside the state
  Snapshot snapshot;
};

// Where the checkpoint before the last one is kept: "a/run.ckpt" -> "a/run_prev.ckpt".
std::filesystem::path previous_checkpoint(const std::filesystem::path& path);

// What a checkpoint is going to hold: a copy, so that a thread may write it beside the solver.
struct CheckpointImage {
  std::string head;  // JSON
  std::string continuation;
  State state;
};
CheckpointImage image_of(const Simulation& simulation, const Origin& origin,
                         std::string continuation = {});

// Writes under a temporary name, reads it back, keeps a former file as previous_checkpoint(), and
// takes its name: at any moment one of the two is whole. Throws Error (files).
void write_checkpoint(const std::filesystem::path& path, const CheckpointImage& image);

// The file is not trusted. Throws Error (files) for one that is cut, changed in any byte, of
// another format, or no checkpoint, and names the previous one if that is whole; Error
// (interrupted).
Checkpoint read_checkpoint(const std::filesystem::path& path);

// Reads the continuation alone; throws the same.
std::string read_continuation(const std::filesystem::path& path);

// Returns the simulation of a checkpoint. Throws Error (files) if it does not fit its own plate,
// and Error (refused) for loads that are functions, which a file cannot hold, naming them.
Simulation resume(Checkpoint checkpoint, const Execution& execution);

}  // namespace hackle
