// SPDX-License-Identifier: MIT
#include "output/export/vtk_file.hpp"

#include <iterator>

#include <fmt/format.h>

#include "base/version.hpp"
#include "output/export/text_output.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;

void add_points(std::string& text, const std::vector<ExportNode>& nodes, const Grid& grid) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "POINTS {} double\n", nodes.size());
  for (const auto& [i, j] : nodes)
    fmt::format_to(out, "{:.12g} {:.12g} 0\n", grid.position(i, j).x(), grid.position(i, j).y());
  fmt::format_to(out, "VERTICES {} {}\n", nodes.size(), 2 * nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) fmt::format_to(out, "1 {}\n", k);
}

void add_field(std::string& text, const Field& field, const std::vector<ExportNode>& nodes,
               const Grid& grid) {
  const auto out = std::back_inserter(text);
  if (field.components == 1)
    fmt::format_to(out, "SCALARS {} float 1\nLOOKUP_TABLE default\n", field.name);
  else
    fmt::format_to(out, "VECTORS {} float\n", field.name);
  for (const auto& [i, j] : nodes) {
    const std::size_t node = grid.index(i, j);
    if (field.components == 1)
      fmt::format_to(out, "{}\n", field.values[node]);
    else
      fmt::format_to(out, "{} {} 0\n", field.values[2 * node], field.values[2 * node + 1]);
  }
}

std::string text_of_state(double time, const std::vector<Field>& fields,
                          const std::vector<ExportNode>& nodes, const Grid& grid) {
  std::string text = fmt::format(
      "# vtk DataFile Version 3.0\nHackle {}, SI units\nASCII\nDATASET POLYDATA\n"
      "FIELD FieldData 1\nTIME 1 1 double\n{:.12g}\n",
      version(), time);
  add_points(text, nodes, grid);
  fmt::format_to(std::back_inserter(text), "POINT_DATA {}\n", nodes.size());
  for (const Field& field : fields) add_field(text, field, nodes, grid);
  return text;
}

fs::path name_of_state(const fs::path& path, std::size_t number, std::size_t count) {
  if (count == 1) return path;
  return path.parent_path() /
         fmt::format("{}_{:04}{}", path.stem().string(), number, path.extension().string());
}

}  // namespace

std::vector<fs::path> write_vtk(StoredRun& run, const ExportChoice& choice, const fs::path& path,
                                const ShareDone& done) {
  std::vector<fs::path> files;
  const std::vector<ExportNode> nodes = export_nodes(run.view().lattice());
  for_each_state(run, choice, done, [&](double time, const std::vector<Field>& fields) {
    files.push_back(name_of_state(path, files.size(), choice.states.size()));
    TextOutput file(files.back());
    file.write(text_of_state(time, fields, nodes, run.view().lattice().grid));
    file.finish();
  });
  return files;
}

}  // namespace hackle
