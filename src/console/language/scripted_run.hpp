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

// Closes the run when the collector destroys it. The session owns the run: where Lua has no memory
// left for a finalizer, the run ends with the session.
class ScriptedRun {
 public:
  ScriptedRun(const std::shared_ptr<Run>& run, Session& session)
      : run_(run.get()), session_(&session) {}
  ScriptedRun(ScriptedRun&& other) noexcept
      : view(std::move(other.view)),
        promised(std::move(other.promised)),
        run_(std::exchange(other.run_, nullptr)),
        session_(other.session_) {}
  ~ScriptedRun() {
    if (run_ != nullptr) session_->retire(run_);
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
  Run* run_;
  Session* session_;
};

template <>
inline constexpr const char* type_name<ScriptedRun> = "hackle.simulation";

}  // namespace hackle
