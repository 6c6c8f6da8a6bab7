// SPDX-License-Identifier: MIT
// A run file, written between steps. It may be read while it is written.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "base/file_lock.hpp"
#include "base/progress.hpp"
#include "output/files/output.hpp"
#include "output/files/output_names.hpp"
#include "output/files/record_options.hpp"
#include "store/journal.hpp"
#include "store/run_file.hpp"

namespace hackle {

class RecordOutput : public Output {
 public:
  RecordOutput(std::filesystem::path path, const RecordOptions& options,
               const Simulation& simulation, Origin origin, Talk talk,
               std::shared_ptr<const OutputNames> names);

  // Sets who tells the tables of the run when the file is completed.
  void take_tables(std::function<std::vector<SeriesTable>()> tables) {
    tables_ = std::move(tables);
  }
  // Is to be told what is done with the simulation beside stepping.
  const std::shared_ptr<Journal>& journal() const { return journal_; }

  void reserve() override;
  void close() override;
  Expected expected(double until, std::int64_t max_looks) const override;
  std::vector<std::filesystem::path> files() const override;
  void add_seconds(StageSeconds& wall) const override { wall.store += store_seconds_; }

  OutputMark mark() const override;
  std::function<void()> settled() override;
  void continue_from(const OutputMark& mark) override;

 private:
  void look(const Simulation& simulation) override;
  std::filesystem::path path_;
  RecordContents contents_;
  Grid grid_;
  std::shared_ptr<Journal> journal_ = std::make_shared<Journal>();
  Origin origin_;
  Talk talk_;
  std::shared_ptr<const OutputNames> names_;
  std::function<std::vector<SeriesTable>()> tables_;
  std::unique_ptr<HeldFile> lock_;  // from reserve() to close()
  std::unique_ptr<RunFile> file_;   // created with the first record
  std::int64_t records_ = 0;
  bool failed_ = false;
  bool complete_ = false;
  double store_seconds_ = 0.0;
};

}  // namespace hackle
