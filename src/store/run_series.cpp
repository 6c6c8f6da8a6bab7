// SPDX-License-Identifier: MIT
#include "store/run_series.hpp"

#include <set>
#include <string>

#include <fmt/format.h>

namespace hackle {
namespace {

constexpr const char* root_name = "series";

std::string free_table_name(const std::string& wanted, std::set<std::string>& taken) {
  std::string name = wanted;
  for (int number = 2; !taken.insert(name).second; ++number)
    name = fmt::format("{}-{}", wanted, number);
  return name;
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

}  // namespace hackle
