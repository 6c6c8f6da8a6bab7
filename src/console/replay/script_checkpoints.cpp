// SPDX-License-Identifier: MIT
#include "console/replay/script_checkpoints.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/terminal.hpp"
#include "base/units.hpp"
#include "solver/simulation.hpp"
#include "store/checkpoint.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

void remove_file(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
}

std::string hash_of(const Checkpoint& checkpoint) {
  return checkpoint.snapshot.state.hash();
}

// Returns the checkpoint of that state: the file, or the one before it, which alone is there if the
// program was killed while it replaced it. Without a hash it is the file.
Checkpoint checkpoint_with(int number, const fs::path& file, const std::string& hash) {
  std::error_code ignored;
  std::vector<fs::path> candidates{file};
  const fs::path previous = previous_checkpoint(file);
  if (!hash.empty() && fs::exists(previous, ignored)) candidates.push_back(previous);
  for (const fs::path& candidate : candidates) try {
      Checkpoint checkpoint = read_checkpoint(candidate);
      if (hash.empty() || hash_of(checkpoint) == hash) return checkpoint;
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::files || candidate == candidates.back()) throw;
    }
  throw Error(ErrorKind::files,
              fmt::format("'{}' has another state of simulation {} than the one to go on from",
                          file.string(), number),
              "--fresh starts anew");
}

}  // namespace

ScriptCheckpoints::ScriptCheckpoints(ScriptHost host)
    : host_(std::move(host)), replay_([this] {
        ReplayHost objects = host_.objects;
        objects.go_live = [this] { restore_all(); };
        return objects;
      }()) {
}

fs::path ScriptCheckpoints::place(int number) {
  const auto known = places_.find(number);
  if (known != places_.end()) return known->second;
  return places_[number] = host_.claim(automatic_checkpoint(host_.inputs.script, number));
}

void ScriptCheckpoints::keep(Run& run, int number, double seconds) {
  run.keep_checkpoints(
      seconds, [this, number] { return place(number); },
      [this, number] { return continuation(number); });
}

// Only a run that nothing has been done to is none of the others.
std::optional<Continuation::Other> ScriptCheckpoints::other(int number) {
  const Run* run = host_.objects.run(number);
  if (run == nullptr || run->simulation().state().step == 0) return std::nullopt;
  run->finish_checkpoints();  // which may be writing that file
  const std::string hash = run->simulation().state().hash();
  const fs::path file = place(number);
  if (kept_hashes_[number] != hash)
    write_checkpoint(file, image_of(run->simulation(), host_.origin));
  kept_hashes_[number] = hash;
  return Continuation::Other{number, file.filename().string(), hash};
}

std::string ScriptCheckpoints::continuation(int number) {
  Continuation all;
  all.inputs = host_.inputs;
  all.origin = host_.origin;
  all.obstacle = replay_.is_behind() ? "a function of it failed after it had changed the plate"
                                     : replay_.obstacle();
  all.journal = replay_.journal();
  all.run = number;
  kept_hashes_.erase(number);
  for (int k = 1; k <= host_.count(); ++k) {
    Run* const run = host_.objects.run(k);
    if (run != nullptr && k != number) run->settle();  // the keeper settles those of the run itself
    if (run != nullptr)
      all.outputs[k] = run->marks();
    else
      all.summaries[k] = host_.summary(k);
    if (k == number) continue;
    if (auto one = other(k)) all.others.push_back(std::move(*one));
  }
  return bytes_of(all);
}

void ScriptCheckpoints::continue_from(Found found) {
  const Continuation& former = found.continuation;
  if (!former.obstacle.empty())
    throw Error(ErrorKind::refused,
                fmt::format("'{}' cannot be continued by running its script again: {}",
                            found.checkpoint.string(), former.obstacle),
                "load goes on from its state, or --fresh starts anew");
  replay_.begin_with(former.journal);
  found_ = std::move(found);
  if (host_.talk == Talk::quiet) return;
  say_note(
      fmt::format("going on with the run that stopped, from '{}'", found_->checkpoint.string()));
}

// NAME.auto-2_prev.ckpt becomes NAME.former-2_prev.ckpt.
void ScriptCheckpoints::set_aside() const {
  std::error_code ignored;
  const fs::path folder = host_.folder();
  for (const auto& file : automatic_checkpoints(folder, host_.inputs.script)) {
    std::string name = file.filename().string();
    name.replace(name.rfind(".auto"), 5, ".former");
    fs::rename(file, folder / name, ignored);
  }
}

std::string ScriptCheckpoints::told(int number) const {
  if (!found_) return {};
  const auto summary = found_->continuation.summaries.find(number);
  return summary == found_->continuation.summaries.end() ? std::string() : summary->second;
}

void ScriptCheckpoints::restore(int number, const fs::path& file, const std::string& hash) {
  Run* run = host_.objects.run(number);
  if (run == nullptr)
    throw Error(ErrorKind::refused,
                fmt::format("the script has no simulation {} any more, which '{}' has", number,
                            file.string()),
                "--fresh starts anew");
  run->restore(checkpoint_with(number, file, hash));
}

// The replay has come to its end: the script goes on.
void ScriptCheckpoints::restore_all() {
  const Continuation& former = found_->continuation;
  const fs::path folder = found_->checkpoint.parent_path();
  restore(former.run, found_->checkpoint, {});
  for (const auto& [number, file, hash] : former.others) restore(number, folder / file, hash);
  Ranks* ranks = host_.ranks;
  if (ranks == nullptr || ranks->leads())
    for (const auto& [number, marks] : former.outputs)
      if (Run* run = host_.objects.run(number)) run->continue_outputs(marks);
  if (ranks != nullptr) ranks->any(0);  // all have read what rank 0 will soon replace
  const Run& run = *host_.objects.run(former.run);
  if (host_.talk != Talk::quiet)
    say_note(fmt::format("the script is where it stopped: {}, step {}",
                         quantity(run.simulation().time(), "s"),
                         grouped(run.simulation().state().step)));
}

// In the background, too, a run may have stopped at its last step, between two observers.
void ScriptCheckpoints::finish() {
  const bool goes_live = replay_.is_replaying();
  replay_.finish();
  if (!goes_live) return;
  if (Run* run = host_.objects.run(found_->continuation.run)) run->wait();
}

void ScriptCheckpoints::keep_last() noexcept {
  // Nothing has been added, or the run that failed has kept its own state, unless it had not begun.
  if (replay_.is_replaying() || (replay_.has_failed() && !places_.empty())) return;
  for (int k = host_.count(); k > 0; --k)
    if (Run* run = host_.objects.run(k); run != nullptr && run->simulation().state().step > 0)
      return run->keep_last();
}

void ScriptCheckpoints::let_go(const Run& run) {
  for (fs::path& file : run.kept_files()) kept_files_.push_back(std::move(file));
}

void ScriptCheckpoints::remove() noexcept {
  try {
    for (int k = 1; k <= host_.count(); ++k)
      if (const Run* run = host_.objects.run(k)) let_go(*run);
    for (const fs::path& file : kept_files_) remove_file(file);
    for (const auto& [number, file] : places_)
      for (const fs::path& kept : {file, previous_checkpoint(file)}) remove_file(kept);
    if (!found_) return;
    for (const fs::path& file :
         automatic_checkpoints(found_->checkpoint.parent_path(), host_.inputs.script))
      remove_file(file);
  } catch (const std::exception&) {  // they stay
  }
}

}  // namespace hackle
