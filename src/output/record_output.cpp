// SPDX-License-Identifier: MIT
#include "output/record_output.hpp"

#include <utility>

#include "base/files.hpp"
#include "base/stopwatch.hpp"

namespace hackle {

RecordOutput::RecordOutput(std::filesystem::path path, const RecordOptions& options,
                           const Simulation& simulation, Origin origin)
    : path_(std::move(path)),
      schedule_("record", options.every, simulation),
      nodes_(simulation.lattice().grid.nodes()),
      origin_(std::move(origin)) {
}

void RecordOutput::observe(const Simulation& simulation) {
  const Stopwatch watch(store_seconds_);
  schedule_.advance(simulation);
  failed_ = true;  // unless the end of this function is reached
  if (!file_) {
    make_folder_of(path_);
    file_ = std::make_unique<RunFile>(path_, simulation, origin_);
  }
  file_->add(simulation);
  failed_ = false;
}

Expected RecordOutput::expected(double until, std::int64_t most_looks) const {
  const std::int64_t records = schedule_.moments(until, most_looks);
  return {path_, records, run_file_bytes(nodes_, records)};
}

void RecordOutput::close() {
  if (failed_ || complete_ || !file_) return;
  const Stopwatch watch(store_seconds_);
  failed_ = true;
  file_->finish();
  failed_ = false;
  complete_ = true;
}

std::vector<std::filesystem::path> RecordOutput::files() const {
  if (!complete_) return {};
  return {file_->path(), file_->sidecar()};
}

}  // namespace hackle
