// SPDX-License-Identifier: MIT
// A run file as the plan of a run: where it begins, what was done, and what was recorded when. And
// the simulation that goes on from an exact record.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/simulation.hpp"
#include "store/hdf5_reader.hpp"
#include "store/inputs_reader.hpp"
#include "store/journal.hpp"
#include "store/record_contents.hpp"
#include "store/run_file.hpp"

namespace hackle {

class RecordedRun {
 public:
  // Throws Error (files) for a file that is not a run file, is damaged, has no record, or has
  // another format version; the scene in it is not checked yet.
  explicit RecordedRun(const std::filesystem::path& path);

  const Hdf5Reader& file() const { return file_; }
  const Inputs& inputs() const { return inputs_; }
  const std::vector<double>& times() const { return times_; }        // s, of the records
  const std::vector<std::int64_t>& steps() const { return steps_; }  // done at each
  bool has_hashes() const { return !hashes_.empty(); }               // not in format 2
  // Of the state after the step of a record; see State.
  std::string hash_of(std::size_t record) const {
    return hashes_.substr(record * hash_digits, hash_digits);
  }
  // What was done since the record before; may throw Error (files).
  std::vector<Deed> deeds_before(std::size_t record) const;

  // The record nearest in time; the earlier one of two.
  std::size_t nearest(double time) const;
  bool is_exact(std::size_t record) const;
  // The simulation in the state of an exact record, after its step, with the loads then in force.
  // Throws Error (refused) for a record that is not exact, and for loads that are functions, which
  // a file cannot hold, naming them; Error (files) for one that is damaged, or a lattice that
  // cannot be built again.
  Simulation simulation_at(std::size_t record, const Execution& execution) const;
  // The same from the scene alone, at the beginning.
  Simulation simulation_at_start(const Execution& execution) const;

 private:
  void read_times();
  Plate plate_at(std::size_t record) const;
  void check_scene(const Plate& plate) const;
  template <class Make>
  Simulation made(const Make& make) const;
  Simulation checked(Simulation simulation) const;

  std::filesystem::path path_;
  // Read through a separate opening before that of `file_`: the library determines the end of a
  // file only once, on opening, and everything counted before lies before that end, however fast
  // the file grows.
  hsize_t count_;
  Hdf5Reader file_;
  std::string inputs_text_;
  Inputs inputs_;
  std::vector<double> times_;
  std::vector<std::int64_t> steps_;
  std::string hashes_;  // one after the other
};

}  // namespace hackle
