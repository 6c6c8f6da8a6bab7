// SPDX-License-Identifier: MIT
// A table of a run that is written while it goes on: CSV with one head line.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/file_lock.hpp"

namespace hackle {

// The head line holds a name for each column, with its unit: time_s,tip_x_m. Names are letters,
// digits and _: nothing needs quotes, pandas offers them as attributes, gnuplot as
// column("tip_x_m"), and a spreadsheet as headings. Numbers are in SI, in the shortest decimals
// that read back to the same double; a cell is empty where there is none. The first column is the
// time, which rises from row to row: so a run that was stopped can go on in its table.
class SeriesFile {
 public:
  // Replaces an older file. Throws Error (files), also where another program writes it.
  SeriesFile(std::filesystem::path path, std::vector<std::string> headings);
  // Goes on in a table with the rows up to `time`, s, and no more than `rows` of them; later ones,
  // and a row that was cut off, are removed. Throws Error (files) if it is not there, has fewer
  // rows where a number is given, or has other headings.
  static SeriesFile reopened(std::filesystem::path path, std::vector<std::string> headings,
                             double time, std::optional<std::int64_t> rows = {});

  // Appends a row with a number, or nothing, for each heading. Rows reach the file within a tenth
  // of a second of wall time, as long as this or settle() is called. Throws Error (files).
  void add(std::span<const std::optional<double>> row);
  // Writes what has waited long enough; costs a look at the clock, and nothing while nothing waits.
  void settle();
  void flush();
  // Writes the rest and lets go of the file.
  void close();

  const std::filesystem::path& path() const { return path_; }
  const std::vector<std::string>& headings() const { return headings_; }

 private:
  using Clock = std::chrono::steady_clock;
  SeriesFile(std::filesystem::path path, std::vector<std::string> headings, bool replaces);

  std::filesystem::path path_;
  std::vector<std::string> headings_;
  std::unique_ptr<FileLock> lock_;
  std::ofstream file_;
  std::string waiting_;
  Clock::time_point last_flush_ = Clock::now();
};

// Returns when the disk has what was written to a file. Throws Error (files).
void bring_to_disk(const std::filesystem::path& path);

// A table that was read: a number, NaN for an empty cell, for each row of each column.
struct SeriesTable {
  std::string name;  // of the file, without folder and extension
  std::vector<std::string> headings;
  std::vector<std::vector<double>> columns;
};

// Reads a table that SeriesFile writes, without a row that was cut off. Throws Error (files) if it
// cannot be read or holds anything else.
SeriesTable read_series(const std::filesystem::path& path);

}  // namespace hackle
