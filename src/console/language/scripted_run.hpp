// SPDX-License-Identifier: MIT
// A simulation as scripts hold it.
#pragma once

#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "console/language/live_view.hpp"
#include "console/lua/object.hpp"
#include "console/session.hpp"

namespace hackle {

// When the collector takes it, the run is closed.
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
  // The same, to read what was computed.
  const Simulation& results() const {
    run_->look();
    return run_->simulation();
  }

  std::shared_ptr<LiveView> view;  // in the terminal, or none
  // Files that movie() and record() will write.
  std::vector<std::filesystem::path> promised;
  // Throws Error (files) when one of them cannot be written any more.
  void check_still_writable() const;

 private:
  std::shared_ptr<Run> run_;
  Session* session_;
};

template <>
inline constexpr const char* type_name<ScriptedRun> = "hackle.simulation";

}  // namespace hackle
