// SPDX-License-Identifier: MIT
// A simulation as a value of scripts.
#pragma once

#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "console/language/live_view.hpp"
#include "console/lua/object.hpp"
#include "console/session.hpp"

namespace hackle {

// Closes the run when the collector destroys it.
class ScriptedRun {
 public:
  ScriptedRun(std::shared_ptr<Run> run, Session& session)
      : run_(std::move(run)), session_(&session) {}
  ScriptedRun(ScriptedRun&&) = default;
  ~ScriptedRun() {
    if (run_) session_->retire(run_.get());
  }

  Run& run() const { return *run_; }
  const Simulation& simulation() const { return run_->simulation(); }
  // Returns the simulation for reading its results.
  const Simulation& results() const {
    run_->look();
    return run_->simulation();
  }

  std::shared_ptr<LiveView> view;  // in the terminal; may be null
  // Files that movie() and record() will write.
  std::vector<std::filesystem::path> promised;
  // Throws Error (files) if one of them can no longer be written.
  void check_still_writable() const;

 private:
  std::shared_ptr<Run> run_;
  Session* session_;
};

template <>
inline constexpr const char* type_name<ScriptedRun> = "hackle.simulation";

}  // namespace hackle
