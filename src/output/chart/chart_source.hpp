// SPDX-License-Identifier: MIT
// What a chart takes its numbers from: tables, and the records of a run.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "measure/node_values.hpp"
#include "store/recording.hpp"
#include "store/series_file.hpp"

namespace hackle {

class ChartSource {
 public:
  // Tables that a run has written so far, and its present state, which must outlive the source.
  ChartSource(std::string name, std::vector<SeriesTable> tables, const View& view);
  // The tables in a run file, and its records for what they lack.
  explicit ChartSource(std::shared_ptr<Recording> recording);
  // A table: a CSV file that s:log or a chart has written. Throws Error (files).
  explicit ChartSource(const std::filesystem::path& table);
  // Numbers of a script.
  explicit ChartSource(SeriesTable table);

  const std::string& name() const { return name_; }
  void rename(std::string name) { name_ = std::move(name); }

  // A column of numbers with its unit, SI; NaN where there is none.
  struct Numbers {
    std::string unit;
    std::vector<double> values;
  };
  struct Pair {
    Numbers x, y;
  };
  // Returns two columns, "time" and "tip.speed", of the first table that has both; else of the
  // records. Nothing if neither knows them.
  std::optional<Pair> pair(const std::string& x, const std::string& y) const;
  // Returns the names of its columns as they can be asked for, without those of records.
  std::vector<std::string> names() const;

  // Returns the speed of Rayleigh waves, m/s, of a run.
  std::optional<double> rayleigh() const;
  // Returns the values of a field; at a time, s, of the nearest record; else at the last one, or
  // now. Nothing of a table.
  std::optional<NodeValues> field(const std::string& name, std::optional<double> time) const;

 private:
  std::optional<Pair> recorded(const std::string& x, const std::string& y) const;

  std::string name_;
  std::vector<SeriesTable> tables_;
  std::optional<View> view_;
  std::shared_ptr<Recording> recording_;
};

}  // namespace hackle
