// SPDX-License-Identifier: MIT
// What every output of a run has in common: it looks at the times of a schedule and leaves files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "output/files/schedule.hpp"
#include "output/report/summary.hpp"

namespace hackle {

// The expected size of an output, written and to come: a measured estimate for compressed files.
struct Expected {
  std::filesystem::path file;
  std::int64_t pieces = 0;  // frames or records
  double bytes = 0.0;
};

class Output : public ScheduledObserver {
 public:
  using ScheduledObserver::ScheduledObserver;

  // Returns the size expected at time `until`, s, for a run with at most `max_looks` more calls.
  virtual Expected expected(double until, std::int64_t max_looks) const = 0;
  // Makes sure that nobody else writes its files and keeps the remains of a killed run; changes
  // nothing else. Called before the first look of a run. Throws Error (files).
  virtual void reserve() {}
  // Completes the files. Call it only once. After a failure that it has already reported, it does
  // nothing.
  virtual void close() = 0;
  // Returns the completed files.
  virtual std::vector<std::filesystem::path> files() const = 0;
  // Adds the wall time spent so far.
  virtual void add_seconds(StageSeconds& wall) const = 0;
};

}  // namespace hackle
