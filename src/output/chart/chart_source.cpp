// SPDX-License-Identifier: MIT
#include "output/chart/chart_source.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "measure/crack_track.hpp"
#include "measure/heading.hpp"
#include "measure/quantity.hpp"
#include "scene/waves.hpp"
#include "store/run_series.hpp"

namespace hackle {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

// Returns the place of a column in a table, and its unit.
std::optional<std::pair<std::size_t, std::string>> find(const SeriesTable& table,
                                                        const std::string& name) {
  for (std::size_t k = 0; k < table.headings.size(); ++k)
    if (auto unit = unit_in_heading(table.headings[k], name)) return std::pair{k, *unit};
  return std::nullopt;
}

std::optional<ChartSource::Pair> pair_in(const SeriesTable& table, const std::string& x,
                                         const std::string& y) {
  const auto along = find(table, x), up = find(table, y);
  if (!along || !up) return std::nullopt;
  return ChartSource::Pair{{along->second, table.columns[along->first]},
                           {up->second, table.columns[up->first]}};
}

// Returns the column, or nothing for what records do not know.
std::optional<Column> recorded_column(const std::string& name, const View& view) {
  try {
    return column_named(name, view, false, "chart");
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

ChartSource::ChartSource(std::string name, std::vector<SeriesTable> tables, const View& view)
    : name_(std::move(name)), tables_(std::move(tables)), view_(view) {
}

ChartSource::ChartSource(std::shared_ptr<Recording> recording)
    : name_(recording->path().stem().string()),
      tables_(series_in(recording->path())),
      recording_(std::move(recording)) {
}

ChartSource::ChartSource(const std::filesystem::path& table)
    : name_(table.stem().string()), tables_{read_series(table)} {
}

ChartSource::ChartSource(SeriesTable table) : name_(table.name), tables_{std::move(table)} {
}

std::optional<ChartSource::Pair> ChartSource::pair(const std::string& x,
                                                   const std::string& y) const {
  for (const SeriesTable& table : tables_)
    if (auto found = pair_in(table, x, y)) return found;
  return recording_ ? recorded(x, y) : std::nullopt;
}

// Visits every record.
std::optional<ChartSource::Pair> ChartSource::recorded(const std::string& x,
                                                       const std::string& y) const {
  const auto along = recorded_column(x, recording_->view());
  const auto up = recorded_column(y, recording_->view());
  if (!along || !up) return std::nullopt;
  Pair found{{along->unit, {}}, {up->unit, {}}};
  CrackTrack cracks;
  const std::size_t shown = recording_->shown();
  for (std::size_t k = 0; k < recording_->times().size(); ++k) {
    throw_if_interrupted();
    recording_->go_to(k);
    const View view = recording_->view();
    cracks.look(view);
    Glance glance(view, cracks, nullptr);
    found.x.values.push_back(along->value(glance).value_or(no_number));
    found.y.values.push_back(up->value(glance).value_or(no_number));
  }
  recording_->go_to(shown);
  return found;
}

std::vector<std::string> ChartSource::names() const {
  std::vector<std::string> all;
  for (const SeriesTable& table : tables_)
    for (const std::string& heading : table.headings) {
      std::string name = name_in_heading(heading);
      if (std::ranges::find(all, name) == all.end()) all.push_back(std::move(name));
    }
  return all;
}

std::optional<double> ChartSource::rayleigh() const {
  if (!view_ && !recording_) return std::nullopt;
  const View view = view_ ? *view_ : recording_->view();
  const Moduli& moduli = view.lattice().calibration.moduli;
  return wave_speeds(moduli.E, moduli.nu, view.lattice().rho, view.plate().plane).rayleigh;
}

std::optional<NodeValues> ChartSource::field(const std::string& name,
                                             std::optional<double> time) const {
  if (view_) return NodeValues(name, *view_);
  if (!recording_) return std::nullopt;
  const std::size_t shown = recording_->shown();
  recording_->go_to(time ? recording_->nearest(*time) : recording_->times().size() - 1);
  NodeValues values(name, recording_->view());
  recording_->go_to(shown);
  return values;
}

}  // namespace hackle
