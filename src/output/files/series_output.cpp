// SPDX-License-Identifier: MIT
#include "output/files/series_output.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "base/stopwatch.hpp"

namespace hackle {
namespace {

constexpr double bytes_of_cell = 19.0;  // measured: 16 or 17 digits, a point, a comma

std::vector<std::string> headings_of(const std::vector<Column>& columns) {
  std::vector<std::string> headings;
  headings.reserve(columns.size());
  for (const Column& column : columns) headings.push_back(heading_of(column));
  return headings;
}

std::vector<std::optional<double>> row_of(const std::vector<Column>& columns, Glance glance) {
  std::vector<std::optional<double>> row;
  row.reserve(columns.size());
  for (const Column& column : columns) row.push_back(column.value(glance));
  return row;
}

// Returns the first of the times first + k every that lies after a time.
double following(double first, double every, double time) {
  constexpr double rounding = 1e-9;
  return first + (std::floor((time - first) / every + rounding) + 1.0) * every;
}

}  // namespace

std::vector<Column> checked_columns(std::vector<Column> columns, const SeriesOptions& options,
                                    const View& view, bool of_run, const std::string& who) {
  if (!(options.along.norm() > 0.0))
    throw Error(ErrorKind::refused,
                fmt::format("{}: along is {{0, 0}}, which is no direction", who),
                "as in along = {1, 0}");
  const auto is_time = [](const Column& column) { return column.name == "time"; };
  std::erase_if(columns, is_time);
  columns.insert(columns.begin(), column_named("time", view, of_run, who));
  std::set<std::string> known;
  for (const std::string& heading : headings_of(columns))
    if (!known.insert(heading).second)
      throw Error(ErrorKind::refused, fmt::format("{}: two columns are named '{}'", who, heading),
                  "name each only once; functions get names by {name = function}");
  return columns;
}

SeriesOutput::SeriesOutput(std::filesystem::path path, const SeriesOptions& options,
                           std::vector<Column> columns, const Simulation& simulation)
    : Output(Schedule("log", options.every.value_or(simulation.dt()), simulation)),
      path_(std::move(path)),
      every_step_(!options.every),
      columns_(std::move(columns)),
      cracks_(options.along) {
}

bool SeriesOutput::due(const Simulation& simulation) {
  const Stopwatch watch(store_seconds_);
  cracks_.follow(simulation);
  if (file_) file_->settle();
  if (!every_step_) return Output::due(simulation);
  // A former program has written the row of the step with which it was left.
  if (std::exchange(continues_, false)) note_row_of(simulation.state());
  const State& state = simulation.state();
  if (state.step == last_step_ && state.clock == last_clock_) return false;
  schedule().go_on(simulation.time_of_step(), 0);  // the row is of this very step
  return true;
}

void SeriesOutput::note_row_of(const State& state) {
  last_step_ = state.step;
  last_clock_ = state.clock;
}

void SeriesOutput::reserve() {
  if (!file_ && !complete_) make_folder_of(path_);
}

void SeriesOutput::look(const Simulation& simulation) {
  const Stopwatch watch(store_seconds_);
  note_row_of(simulation.state());
  const auto row = row_of(columns_, Glance(simulation.view(), cracks_, &simulation));
  failed_ = true;  // unless this function completes
  if (!file_) file_.emplace(path_, headings_of(columns_));
  file_->add(row);
  ++rows_;
  failed_ = false;
}

std::function<void()> SeriesOutput::settled() {
  if (file_ && !complete_) file_->flush();
  return [path = path_] { bring_to_disk(path); };
}

OutputMark SeriesOutput::mark() const {
  OutputMark mark = mark_at(path_, rows_, complete_);
  mark.memory = cracks_.memory();
  return mark;
}

void SeriesOutput::continue_from(const OutputMark& mark) {
  cracks_.recall(mark.memory);
  schedule().go_on(mark.start, mark.next);
  rows_ = mark.pieces;
  complete_ = mark.complete;
  continues_ = true;
  if (!complete_ && rows_ > 0)
    file_.emplace(SeriesFile::reopened(path_, headings_of(columns_),
                                       std::numeric_limits<double>::infinity(), rows_));
}

Expected SeriesOutput::expected(double until, std::int64_t max_looks) const {
  const std::int64_t rows = schedule().moments(until, max_looks);
  const double cells = static_cast<double>(rows) * static_cast<double>(columns_.size());
  return {path_, rows, bytes_of_cell * cells};
}

void SeriesOutput::close() {
  if (failed_ || complete_ || !file_) return;
  const Stopwatch watch(store_seconds_);
  failed_ = true;
  file_->close();
  failed_ = false;
  complete_ = true;
}

std::vector<std::filesystem::path> SeriesOutput::files() const {
  if (!complete_) return {};
  return {path_};
}

std::optional<SeriesTable> SeriesOutput::table() {
  if (!file_) return std::nullopt;
  if (!complete_) file_->flush();
  return read_series(path_);
}

void write_table(Recording& recording, const std::filesystem::path& path,
                 const SeriesOptions& options, const std::vector<Column>& columns) {
  CrackTrack cracks(options.along);
  SeriesFile file(path, headings_of(columns));
  const std::size_t shown = recording.shown();
  const double first = recording.times().front();
  double next = first;
  for (std::size_t k = 0; k < recording.times().size(); ++k) {
    throw_if_interrupted();
    const double time = recording.times()[k];
    if (options.every && time < next - 1e-9 * *options.every) continue;
    recording.go_to(k);
    const View view = recording.view();
    cracks.look(view);
    file.add(row_of(columns, Glance(view, cracks, nullptr)));
    if (options.every) next = following(first, *options.every, time);
  }
  file.close();
  recording.go_to(shown);
}

}  // namespace hackle
