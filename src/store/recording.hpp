// SPDX-License-Identifier: MIT
// A run that was recorded, put back into its recorded states: what can be asked of a simulation can
// be asked of it again, without computing.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "solver/simulation.hpp"
#include "store/run_file.hpp"

namespace hackle {

class Recording {
 public:
  // Opens a run file and shows its first record. A file whose run was killed has the records that
  // were committed. The lattice is built anew from the inputs in the file and must be the same, to
  // the bit. Throws Error (files) for a file that is no run file, is damaged, holds no record, or
  // was written in another format, with what to do.
  explicit Recording(const std::filesystem::path& path, Execution execution = {});
  ~Recording();

  const std::filesystem::path& path() const;
  const Origin& origin() const;  // the script that made the run
  // The plate with all that acted on it, functions apart; see Inputs.
  const Plate& plate() const;
  const std::vector<double>& times() const;  // s, of the records, ascending; at least one
  // The record whose time is nearest; of two, the earlier one.
  std::size_t nearest(double time) const;

  // Shows record k < times().size(). Throws Error (files) when it is damaged; what is shown then is
  // as before.
  void go_to(std::size_t record);
  std::size_t shown() const;
  // The record that is shown. Damage, bonds, discs and the time are as they were; u, v and thermal
  // strain to the single precision of the file. Energy that was put in is not recorded.
  const Simulation& simulation() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
