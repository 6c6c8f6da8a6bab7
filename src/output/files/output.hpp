// SPDX-License-Identifier: MIT
// What every output of a run has in common: it looks at the times of a schedule and leaves files.
// Where a run may go on in another program, an output can do so too: from a mark, behind what the
// former program left.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "base/error.hpp"
#include "output/files/output_mark.hpp"
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

  // Called before the first look: from now on keeps what another program needs to go on.
  virtual void keep_continuable() {}
  // Returns the files that only this needs; they outlive the object.
  virtual std::vector<std::filesystem::path> kept_files() const { return {}; }
  // Returns how far it has come. Called on the solver's thread, between steps.
  virtual OutputMark mark() const { return mark_at(expected(0.0, 0).file, 0, false); }
  // Returns a function that returns when the disk has all pieces of the present mark, if the output
  // is continuable. It may be called on another thread and after the output is gone. Throws Error
  // (files).
  virtual std::function<void()> settled() {
    return [] {};
  }
  // Instead of beginning anew, goes on behind the mark in what a former program left: later pieces
  // are dropped. A complete file is not touched. Called at most once, before the first look. Throws
  // Error (files), with a remedy, if too little is left.
  virtual void continue_from(const OutputMark& mark) { refuse_to_continue(mark); }

 protected:
  [[noreturn]] static void refuse_to_continue(const OutputMark& mark) {
    throw Error(ErrorKind::files, "'" + mark.file.string() + "' cannot be continued",
                "begin anew with --fresh");
  }
  OutputMark mark_at(const std::filesystem::path& file, std::int64_t pieces, bool complete) const {
    return {file, pieces, schedule().start(), schedule().passed(), complete};
  }
};

}  // namespace hackle
