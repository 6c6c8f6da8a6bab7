// SPDX-License-Identifier: MIT
// The checkpoints that a script keeps of its simulations by itself, and what it needs to go on from
// those of a former life that was interrupted, failed or was killed.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/ranks/ranks.hpp"
#include "console/replay/continuation.hpp"
#include "console/replay/replay.hpp"
#include "output/run/run.hpp"

namespace hackle {

// The script, its files and its simulations.
struct ScriptHost {
  RunInputs inputs;
  Origin origin;
  Talk talk = Talk::plain;
  std::function<std::filesystem::path()> folder;  // of the output; taken when it is asked for
  // Reserves a checkpoint below it.
  std::function<std::filesystem::path(const std::filesystem::path& name)> claim;
  std::function<int()> count;
  Ranks* ranks = nullptr;                          // that run the script together
  std::function<std::string(int number)> summary;  // JSON, of a simulation that is gone
  ReplayHost objects;                              // without go_live, which is set here
};

class ScriptCheckpoints {
 public:
  explicit ScriptCheckpoints(ScriptHost host);

  Replay& replay() { return replay_; }
  // Keeps the state of a run every `seconds` of wall time, and when it ends early.
  void keep(Run& run, int number, double seconds);

  // Replays the script up to where it stopped, according to what was found. Throws Error (refused)
  // if the script cannot be replayed.
  void continue_from(Found found);
  // Sets aside the checkpoints of a former life, which this one does not continue, under the name
  // NAME.former.ckpt.
  void set_aside() const;
  // Returns the JSON that the former life told of a simulation which was gone by then; or nothing.
  std::string told(int number) const;

  // The script has ended: a replay comes to its end too. Throws what Replay::finish throws, and
  // what functions of the script throw.
  void finish();
  // Keeps the last state of a script that has failed between two runs, so that it can go on there.
  void keep_last() noexcept;
  // A run is about to go; what only its continuation needs remains until remove().
  void let_go(const Run& run);
  // Removes what was kept for a failure that did not come. All runs are still there.
  void remove() noexcept;

 private:
  std::string continuation(int number);
  std::optional<Continuation::Other> other(int number);
  void restore_all();
  void restore(int number, const std::filesystem::path& file, const std::string& hash);
  std::filesystem::path place(int number);

  ScriptHost host_;
  Replay replay_;
  std::optional<Found> found_;
  std::map<int, std::filesystem::path> places_;
  std::map<int, std::string> kept_hashes_;  // of the states that checkpoints of others have
  std::vector<std::filesystem::path> kept_files_;
};

}  // namespace hackle
