// SPDX-License-Identifier: MIT
#include "output/files/record_output.hpp"

#include <cstdio>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/files.hpp"
#include "base/on_disk.hpp"
#include "base/partial_file.hpp"
#include "base/stopwatch.hpp"
#include "base/terminal.hpp"
#include "store/run_rescue.hpp"
#include "store/xdmf.hpp"

namespace hackle {
namespace {

// Steps are counted from the last one, which the plate may be seen before.
Schedule schedule_of(const RecordOptions& options, const Simulation& simulation) {
  const View view = simulation;
  return Schedule("record", interval_of(options, view.dt()), options.steps ? view.at_step() : view);
}

}  // namespace

RecordOutput::RecordOutput(std::filesystem::path path, const RecordOptions& options,
                           const Simulation& simulation, Origin origin, Talk talk,
                           std::shared_ptr<const OutputNames> names)
    : Output(schedule_of(options, simulation)),
      path_(std::move(path)),
      contents_(contents_of(options, simulation.lattice())),
      grid_(simulation.lattice().grid),
      origin_(std::move(origin)),
      talk_(talk),
      names_(std::move(names)) {
  check_name(path_);
}

void RecordOutput::reserve() {
  if (lock_ || complete_) return;
  make_folder_of(path_);
  auto lock = std::make_unique<HeldFile>(recording_lock(path_), path_);
  const std::optional<RescuedRun> rescued = rescue_run(
      path_, [&](const std::filesystem::path& name) { return names_->is_claimed(name); });
  lock_ = std::move(lock);
  if (rescued && talk_ != Talk::quiet)
    say_note(
        fmt::format("an earlier run was cut off while it recorded '{}': its {} records are kept "
                    "as '{}'",
                    path_.string(), rescued->records, rescued->file.string()));
}

void RecordOutput::look(const Simulation& simulation) {
  const Stopwatch watch(store_seconds_);
  failed_ = true;  // unless this function completes
  reserve();
  if (!file_) {
    file_ = std::make_unique<RunFile>(path_, simulation, origin_, contents_);
    journal_->begin();
  }
  file_->add(simulation, journal_->take(simulation));
  ++records_;
  failed_ = false;
}

OutputMark RecordOutput::mark() const {
  OutputMark mark = mark_at(path_, records_, complete_);
  if (file_ && !complete_) mark.note = journal_->pending();
  return mark;
}

std::function<void()> RecordOutput::settled() {
  return [path = path_] { bring_file_to_disk(path); };
}

void RecordOutput::continue_from(const OutputMark& mark) {
  schedule().go_on(mark.start, mark.next);
  records_ = mark.pieces;
  complete_ = mark.complete;
  if (complete_) return;
  make_folder_of(path_);
  lock_ = std::make_unique<HeldFile>(recording_lock(path_), path_);
  if (records_ == 0) return;
  file_ = std::make_unique<RunFile>(path_, grid_, contents_, records_);
  journal_->resume(mark.note);
}

Expected RecordOutput::expected(double until, std::int64_t max_looks) const {
  const std::int64_t records = schedule().moments(until, max_looks);
  return {path_, records, run_file_bytes(contents_, grid_, records)};
}

void RecordOutput::close() {
  if (failed_ || complete_ || !file_) return;
  const Stopwatch watch(store_seconds_);
  failed_ = true;
  if (tables_) file_->add(tables_());
  file_->finish();
  lock_.reset();
  failed_ = false;
  complete_ = true;
}

std::vector<std::filesystem::path> RecordOutput::files() const {
  if (!complete_) return {};
  return {path_, sidecar_of(path_)};
}

}  // namespace hackle
