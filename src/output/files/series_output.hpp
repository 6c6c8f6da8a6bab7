// SPDX-License-Identifier: MIT
// A table of numbers that is written while a plate is solved.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "measure/crack_track.hpp"
#include "measure/quantity.hpp"
#include "output/files/output.hpp"
#include "output/files/series_options.hpp"
#include "store/recording.hpp"
#include "store/series_file.hpp"

namespace hackle {

// Returns the columns with the time as the first of them, whether it is named or not. Throws Error
// (refused), naming `who`, for two of one heading and for a direction of no length.
std::vector<Column> checked_columns(std::vector<Column> columns, const SeriesOptions& options,
                                    const View& view, bool of_run, const std::string& who);

class SeriesOutput : public Output {
 public:
  // `columns` as checked_columns() returns them.
  SeriesOutput(std::filesystem::path path, const SeriesOptions& options,
               std::vector<Column> columns, const Simulation& simulation);

  // Follows the cracks in every step, and lets rows that have waited reach the file.
  std::int64_t next_due(const Simulation& simulation) override { return simulation.state().step; }
  bool due(const Simulation& simulation) override;
  void reserve() override;
  void close() override;
  Expected expected(double until, std::int64_t max_looks) const override;
  std::vector<std::filesystem::path> files() const override;
  void add_seconds(StageSeconds& wall) const override { wall.store += store_seconds_; }
  OutputMark mark() const override;
  std::function<void()> settled() override;
  void continue_from(const OutputMark& mark) override;

  // Returns the rows so far; nothing before the first.
  std::optional<SeriesTable> table();

 private:
  void look(const Simulation& simulation) override;
  void note_row_of(const State& state);

  std::filesystem::path path_;
  bool every_step_;
  std::vector<Column> columns_;
  CrackTrack cracks_;
  std::optional<SeriesFile> file_;  // created with the first row
  std::int64_t rows_ = 0;
  bool continues_ = false;  // and no step has been seen since
  // The last row, where every step has one.
  std::int64_t last_step_ = -1;
  Clock last_clock_;
  bool failed_ = false;
  bool complete_ = false;
  double store_seconds_ = 0.0;
};

// Writes the table of a recording, a row for each record. Throws what the columns throw and Error
// (files), Error (interrupted) on Ctrl-C.
void write_table(Recording& recording, const std::filesystem::path& path,
                 const SeriesOptions& options, const std::vector<Column>& columns);

}  // namespace hackle
