// SPDX-License-Identifier: MIT
#include "store/run_series.hpp"

#include <set>
#include <string>

#include <fmt/format.h>

#include "scene/load_names.hpp"
#include "store/hdf5_reader.hpp"

namespace hackle {
namespace {

constexpr const char* root_name = "series";

std::string free_table_name(const std::string& wanted, std::set<std::string>& taken) {
  std::string name = wanted;
  for (int number = 2; !taken.insert(name).second; ++number)
    name = fmt::format("{}-{}", wanted, number);
  return name;
}

// Names stand in messages and beside axes, so they must be those that we write.
SeriesTable table_in(const Hdf5Reader& reader, const std::string& name) {
  SeriesTable table{name, {}, {}};
  const std::string group = fmt::format("{}/{}", root_name, name);
  for (const std::string& heading : reader.names(group)) {
    if (!is_identifier(heading)) reader.refuse("a name in its series is damaged");
    const std::string column = fmt::format("{}/{}", group, heading);
    table.headings.push_back(heading);
    table.columns.push_back(reader.first_doubles(column, reader.length(column)));
    if (table.columns.back().size() != table.columns.front().size())
      reader.refuse("the columns of its series have different lengths");
  }
  return table;
}

}  // namespace

void write_series(Hdf5File& file, std::span<const SeriesTable> tables) {
  if (tables.empty()) return;
  std::set<std::string> taken;
  file.name(file.group(static_cast<unsigned>(tables.size())), root_name);
  for (const SeriesTable& table : tables) {
    if (table.columns.empty() || table.columns.front().empty()) continue;
    const Hdf5Handle group = file.group(static_cast<unsigned>(table.columns.size()));
    for (std::size_t k = 0; k < table.columns.size(); ++k)
      file.write(group,
                 {table.headings[k],
                  H5T_IEEE_F64LE,
                  {table.columns[k].size()},
                  "",
                  fmt::format("column {} of the table, in SI units", k + 1)},
                 H5T_NATIVE_DOUBLE, 1, table.columns[k].data());
    file.name(group, fmt::format("{}/{}", root_name, free_table_name(table.name, taken)));
  }
  file.flush();
}

std::vector<SeriesTable> series_in(const std::filesystem::path& run_file) {
  const Hdf5Reader reader(run_file);
  std::vector<SeriesTable> tables;
  if (!reader.holds(root_name)) return tables;
  for (const std::string& name : reader.names(root_name)) tables.push_back(table_in(reader, name));
  return tables;
}

}  // namespace hackle
