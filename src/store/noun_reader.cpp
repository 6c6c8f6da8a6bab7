// SPDX-License-Identifier: MIT
#include "store/noun_reader.hpp"

#include <charconv>

#include "base/error.hpp"
#include "base/interrupt.hpp"

namespace hackle {
namespace {

// Of a bitmap, the limit when it is read.
constexpr std::int64_t max_cells = std::int64_t{1} << 24;
constexpr std::int64_t max_cells_in_all = 4 * max_cells;

// Returns the numbers of "12 3 40".
std::vector<std::int64_t> lengths_in(const std::string& text) {
  std::vector<std::int64_t> list;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at < end; ++at) {
    std::int64_t length = 0;
    const auto [rest, failure] = std::from_chars(at, end, length);
    if (failure != std::errc() || (rest != end && *rest != ' '))
      refuse_inputs("a picture is no picture");
    list.push_back(length);
    at = rest;
  }
  return list;
}

std::vector<std::uint8_t> cells_of(const std::vector<std::int64_t>& lengths, std::int64_t count) {
  std::vector<std::uint8_t> list;
  std::uint8_t value = 0;
  for (const std::int64_t length : lengths) {
    const auto room = count - static_cast<std::int64_t>(list.size());
    if (length < 0 || length > room) refuse_inputs("a picture has too many cells");
    list.insert(list.end(), static_cast<std::size_t>(length), value);
    value = value == 0 ? 1 : 0;
  }
  if (static_cast<std::int64_t>(list.size()) != count) refuse_inputs("a picture has too few cells");
  return list;
}

}  // namespace

void refuse_inputs(const std::string& what) {
  throw Error(ErrorKind::files, "the inputs of the run cannot be read: " + what);
}

void refuse_function() {
  throw Error(ErrorKind::files, "functions of a script are not in its run file",
              "run the script again");
}

std::vector<std::uint8_t> Cells::read(const NounWriter::Json& run_lengths, std::int64_t count) {
  if (count < 0 || count > max_cells) refuse_inputs("a picture is too large");
  if ((all_ += count) > max_cells_in_all) refuse_inputs("its pictures are too many");
  throw_if_interrupted();
  const auto lengths = run_lengths.is_string()
                           ? lengths_in(run_lengths.get_ref<const std::string&>())
                           : run_lengths.get<std::vector<std::int64_t>>();
  return cells_of(lengths, count);
}

void NounReader::read(const Json& json, Bitmap& bitmap) {
  read(json.at("from_m"), bitmap.min);
  read(json.at("to_m"), bitmap.max);
  bitmap.columns = json.at("columns").get<int>();
  bitmap.rows = json.at("rows").get<int>();
  if (bitmap.columns < 1 || bitmap.rows < 1) refuse_inputs("a picture has no cells");
  bitmap.inside = cells_.read(json.at("run_lengths"), std::int64_t{bitmap.columns} * bitmap.rows);
}

}  // namespace hackle
