// SPDX-License-Identifier: MIT
// A recorded run, shown in its recorded states: whatever looks at a view works on it. It has
// neither a stepper nor what acts on the plate.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "solver/view.hpp"
#include "store/run_file.hpp"

namespace hackle {

class Recording {
 public:
  // Opens a run file and shows its first record. If the run was killed, the file has the committed
  // records. The lattice is rebuilt from the inputs in the file and must be identical to the bit.
  // Throws Error (files), with a remedy, for a file that is not a run file, is damaged, has no
  // record, or has another format version.
  explicit Recording(const std::filesystem::path& path);
  ~Recording();

  const std::filesystem::path& path() const;
  const Origin& origin() const;  // the script that made the run
  // Returns the plate with its loads, without functions; see Inputs.
  const Plate& plate() const;
  const std::vector<double>& times() const;  // s, of the records, ascending; at least one
  // Returns the record nearest in time; the earlier one of two.
  std::size_t nearest(double time) const;

  // Shows record k < times().size(). Throws Error (files) if it is damaged; the previous record
  // then stays shown.
  void go_to(std::size_t record);
  std::size_t shown() const;
  // Returns the shown record. Damage, bonds, discs and time are exact; u, v and thermal strain have
  // the single precision of the file. The external work is not recorded. The view holds until the
  // next go_to().
  View view() const;

  std::size_t bytes() const;  // that grow with the plate

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
