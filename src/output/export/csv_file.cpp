// SPDX-License-Identifier: MIT
#include "output/export/csv_file.hpp"

#include <iterator>

#include <fmt/format.h>

#include "output/export/text_output.hpp"

namespace hackle {
namespace {

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} ({})", name, unit);
}

std::string head_of(const std::vector<Field>& fields) {
  std::string head = "time (s),x (m),y (m)";
  for (const Field& field : fields)
    for (int part = 0; part < field.components; ++part) {
      const char* axis = field.components == 1 ? "" : part == 0 ? "_x" : "_y";
      head += fmt::format(",{}", with_unit(fmt::format("{}{}", field.name, axis), field.unit));
    }
  return fmt::format("{}\n", head);
}

void add_row(std::string& text, double time, const Vec2& place, std::size_t node,
             const std::vector<Field>& fields) {
  fmt::format_to(std::back_inserter(text), "{:.12g},{:.12g},{:.12g}", time, place.x(), place.y());
  for (const Field& field : fields) {
    const auto count = static_cast<std::size_t>(field.components);
    for (std::size_t part = 0; part < count; ++part)
      fmt::format_to(std::back_inserter(text), ",{}", field.values[count * node + part]);
  }
  text += '\n';
}

}  // namespace

void write_csv(StoredRun& run, const ExportChoice& choice, const std::filesystem::path& path,
               const ShareDone& done) {
  TextOutput file(path);
  file.write(head_of(export_fields(run, choice)));
  const std::vector<ExportNode> nodes = export_nodes(run.view().lattice());
  for_each_state(run, choice, done, [&](double time, const std::vector<Field>& fields) {
    const Grid grid = run.view().lattice().grid;
    std::string text;
    for (const auto& [i, j] : nodes)
      add_row(text, time, grid.position(i, j), grid.index(i, j), fields);
    file.write(text);
  });
  file.finish();
}

}  // namespace hackle
