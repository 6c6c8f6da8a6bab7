// SPDX-License-Identifier: MIT
// A run in a file, to look at: the records of a run file, or the one state of a checkpoint.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "base/origin.hpp"
#include "solver/view.hpp"
#include "store/inputs_reader.hpp"
#include "store/stored_kind.hpp"

namespace hackle {

class StoredRun {
 public:
  // Opens a run file or a checkpoint and shows its first state. Throws Error (files) for anything
  // else and for a damaged one, Error (interrupted).
  explicit StoredRun(const std::filesystem::path& path);
  ~StoredRun();

  const std::filesystem::path& path() const;
  StoredKind kind() const;
  const Origin& origin() const;
  const Inputs& inputs() const;              // as the run was begun, or with the loads in force
  const std::vector<double>& times() const;  // s, of its states, ascending; at least one
  std::int64_t last_step() const;            // of the last state

  // Shows state k < times().size(). Throws Error (files).
  void show(std::size_t k);
  // Of the state that is shown; holds until the next show().
  View view() const;
  // Whether velocities belong to the time of the state. Those of a checkpoint whose loads are
  // functions, which no file can hold, are half a step older.
  bool velocity_is_of_its_time() const;
  // Whether its numbers are those of the run, to the last bit, and not floats.
  bool is_exact() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
