// SPDX-License-Identifier: MIT
// What every output of a run can do.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "output/report/summary.hpp"
#include "solver/observer.hpp"

namespace hackle {

// What an output has written and is going to write: a measured guess for what is compressed.
struct Expected {
  std::filesystem::path file;
  std::int64_t pieces = 0;  // frames or records
  double bytes = 0.0;
};

class Output : public Observer {
 public:
  // By the time `until`, s, of a run that lets it look at most so many times more.
  virtual Expected expected(double until, std::int64_t max_looks) const = 0;
  // Makes sure that nobody else writes its files, keeps what a killed run has left of them, and
  // changes nothing else. Before the first look of a run. Throws Error (files).
  virtual void reserve() {}
  // Completes the files. Once only. After a failure it has already reported, does nothing.
  virtual void close() = 0;
  // The files it has completed.
  virtual std::vector<std::filesystem::path> files() const = 0;
  // Adds the wall time it took so far.
  virtual void add_seconds(StageSeconds& wall) const = 0;
};

}  // namespace hackle
