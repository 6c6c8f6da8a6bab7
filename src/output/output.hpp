// SPDX-License-Identifier: MIT
// What every output of a run can do.
#pragma once

#include <filesystem>
#include <vector>

#include "output/summary.hpp"
#include "solver/observer.hpp"

namespace hackle {

class Output : public Observer {
 public:
  // Completes the files. Once only. After a failure it has already reported, does nothing.
  virtual void close() = 0;
  // The files it has completed.
  virtual std::vector<std::filesystem::path> files() const = 0;
  // Adds the wall time it took so far.
  virtual void add_seconds(StageSeconds& wall) const = 0;
};

}  // namespace hackle
