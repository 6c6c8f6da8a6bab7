// SPDX-License-Identifier: MIT
// A run file, written between steps.
#pragma once

#include <memory>

#include "output/output.hpp"
#include "output/run.hpp"
#include "output/schedule.hpp"

namespace hackle {

class RecordOutput : public Output {
 public:
  RecordOutput(std::filesystem::path path, const RecordOptions& options,
               const Simulation& simulation, Origin origin);

  bool due(const Simulation& simulation) override { return schedule_.reached(simulation); }
  void observe(const Simulation& simulation) override;
  void close() override;
  Expected expected(double until, std::int64_t most_looks) const override;
  std::vector<std::filesystem::path> files() const override;
  void add_seconds(StageSeconds& wall) const override { wall.store += store_seconds_; }

 private:
  std::filesystem::path path_;
  Schedule schedule_;
  std::size_t nodes_;
  Origin origin_;
  std::unique_ptr<RunFile> file_;  // created with the first record
  bool failed_ = false;
  bool complete_ = false;
  double store_seconds_ = 0.0;
};

}  // namespace hackle
