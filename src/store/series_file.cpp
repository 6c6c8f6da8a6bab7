// SPDX-License-Identifier: MIT
#include "store/series_file.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/files.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::milliseconds longest_wait{100};

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line.append(line.empty() ? "" : ",").append(word);
  return line;
}

[[noreturn]] void refuse_table(const fs::path& path, const std::string& why) {
  throw Error(ErrorKind::files, fmt::format("cannot read the table '{}': {}", path.string(), why),
              "s:log writes such tables");
}

// Returns the complete lines of a text: the last one may have been cut off.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return lines;
}

std::vector<std::string_view> cells_in(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t end = line.find(','); end != std::string_view::npos; end = line.find(',')) {
    cells.push_back(line.substr(0, end));
    line.remove_prefix(end + 1);
  }
  cells.push_back(line);
  return cells;
}

// Returns NaN for an empty cell, and nothing for one that holds no number.
std::optional<double> number_in(std::string_view cell) {
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

// Returns how many bytes of a table belong to its head and the rows that are kept.
std::size_t kept_bytes(const fs::path& path, const std::vector<std::string_view>& lines,
                       double time, std::optional<std::int64_t> rows) {
  std::size_t kept = lines.front().size() + 1;
  std::int64_t row = 0;
  for (auto line = lines.begin() + 1; line != lines.end() && row != rows; ++line, ++row) {
    const std::optional<double> when = number_in(cells_in(*line).front());
    if (!when || std::isnan(*when)) refuse_table(path, fmt::format("row {} has no time", row + 1));
    if (*when > time) break;
    kept += line->size() + 1;
  }
  if (rows && row < *rows)
    refuse_table(path, fmt::format("it has {} rows, there should be {}", row, *rows));
  return kept;
}

}  // namespace

SeriesFile::SeriesFile(fs::path path, std::vector<std::string> headings, bool replaces)
    : path_(std::move(path)), headings_(std::move(headings)) {
  make_folder_of(path_);
  lock_ = std::make_unique<FileLock>(path_, true);
  if (lock_->is_foreign()) refuse_locked(path_, path_);
  file_.open(path_,
             replaces ? std::ios::binary | std::ios::trunc : std::ios::binary | std::ios::app);
  if (replaces) waiting_ = joined(headings_) + "\n";
  flush();
}

SeriesFile::SeriesFile(fs::path path, std::vector<std::string> headings)
    : SeriesFile(std::move(path), std::move(headings), true) {
}

SeriesFile SeriesFile::reopened(fs::path path, std::vector<std::string> headings, double time,
                                std::optional<std::int64_t> rows) {
  const std::string text = read_text(path);
  const std::vector<std::string_view> lines = lines_of(text);
  if (lines.empty() || lines.front() != joined(headings))
    refuse_table(path, "its columns are others than those asked for");
  std::error_code error;
  fs::resize_file(path, kept_bytes(path, lines, time, rows), error);
  if (error) refuse_table(path, error.message());
  return {std::move(path), std::move(headings), false};
}

void SeriesFile::add(std::span<const std::optional<double>> row) {
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (k > 0) waiting_ += ',';
    if (row[k]) fmt::format_to(std::back_inserter(waiting_), "{}", *row[k]);
  }
  waiting_ += '\n';
  settle();
}

void SeriesFile::settle() {
  if (!waiting_.empty() && Clock::now() - last_flush_ >= longest_wait) flush();
}

void SeriesFile::flush() {
  file_.write(waiting_.data(), static_cast<std::streamsize>(waiting_.size()));
  file_.flush();
  if (!file_)
    throw Error(ErrorKind::files, fmt::format("cannot write the table '{}'", path_.string()),
                "is its folder writable, and the disk not full?");
  waiting_.clear();
  last_flush_ = Clock::now();
}

void SeriesFile::close() {
  if (!file_.is_open()) return;
  flush();
  file_.close();
  lock_.reset();
}

void bring_to_disk(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;  // no row has been written yet
  const bool done = ::fsync(file) == 0;
  const int failure = errno;
  ::close(file);
  if (!done && failure != EINVAL)  // what cannot be synced, such as a pipe
    throw Error(ErrorKind::files, fmt::format("cannot write the table '{}': {}", path.string(),
                                              std::generic_category().message(failure)));
}

SeriesTable read_series(const fs::path& path) {
  const std::string text = read_text(path);
  const std::vector<std::string_view> lines = lines_of(text);
  if (lines.empty()) refuse_table(path, "it has no head line");
  SeriesTable table{path.stem().string(), {}, {}};
  for (const std::string_view cell : cells_in(lines.front())) table.headings.emplace_back(cell);
  table.columns.resize(table.headings.size());
  for (std::size_t row = 1; row < lines.size(); ++row) {
    const std::vector<std::string_view> cells = cells_in(lines[row]);
    if (cells.size() != table.headings.size())
      refuse_table(path, fmt::format("row {} has {} cells, its head line {}", row, cells.size(),
                                     table.headings.size()));
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const std::optional<double> value = number_in(cells[k]);
      if (!value) refuse_table(path, fmt::format("row {} holds something that is no number", row));
      table.columns[k].push_back(*value);
    }
  }
  return table;
}

}  // namespace hackle
