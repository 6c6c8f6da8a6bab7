// SPDX-License-Identifier: MIT
#include "store/xdmf.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/markup.hpp"
#include "base/utf8.hpp"
#include "store/record_contents.hpp"

namespace hackle {
namespace {

// Describes a field of one record. Only whole datasets: ParaView's two readers, XDMF 2 and XDMF 3,
// each misread the way in which the other refers to parts of a dataset.
std::string attribute(const Grid& grid, const std::string& source, const SidecarField& field) {
  return fmt::format(
      R"(      <Attribute Name="{name}" AttributeType="{type}" Center="Node">
        <DataItem Dimensions="1 {ny} {nx}{last}" NumberType="Float" Precision="{precision}" Format="HDF">{source}/{name}</DataItem>
      </Attribute>
)",
      fmt::arg("name", field.name), fmt::arg("type", field.components == 1 ? "Scalar" : "Vector"),
      fmt::arg("ny", grid.ny), fmt::arg("nx", grid.nx),
      fmt::arg("last", field.components == 1 ? "" : " 3"), fmt::arg("source", source),
      fmt::arg("precision", field.precision));
}

// Describes the material, the same for all records. A threshold below 255 hides cut-outs.
std::string material_attribute(const Grid& grid, const std::string& file) {
  return fmt::format(
      R"(      <Attribute Name="material" AttributeType="Scalar" Center="Node">
        <DataItem Dimensions="1 {} {}" NumberType="UChar" Precision="1" Format="HDF">{}:/material</DataItem>
      </Attribute>
)",
      grid.ny, grid.nx, file);
}

}  // namespace

void check_name(const std::filesystem::path& run_file) {
  const std::string name = run_file.filename().string();
  const auto refuse = [&](const std::string& what) {
    throw Error(ErrorKind::refused,
                fmt::format("record: ParaView cannot open a run file whose name {}", what),
                "letters, digits, '_', '-', '.' and blanks between them always do");
  };
  if (name.find_first_of(":|") != std::string::npos) refuse("holds ':' or '|'");
  if (std::ranges::any_of(name, [](unsigned char c) { return std::iscntrl(c) != 0; }))
    refuse("holds control characters");
  if (!is_utf8(name)) refuse("is not in UTF-8");
  if (name.front() == ' ') refuse("begins with a blank");
  const std::string stem = run_file.stem().string();
  if (stem.back() == ' ') refuse("ends in a blank");
}

std::string record_group(std::size_t record) {
  return fmt::format("records/{}/{:05}", record / records_a_group, record);
}

std::vector<SidecarField> standard_sidecar() {
  return {{"damage"}, {"displacement", 3}, {"velocity", 3}};
}

std::vector<SidecarField> sidecar_fields(const RecordContents& contents) {
  std::vector<SidecarField> list;
  for (const std::string& name : contents.fields) {
    if (name == "bonds") continue;
    const bool vector = name == "displacement" || name == "velocity";
    list.push_back({name, vector ? 3 : 1, vector && contents.exact ? 8 : 4});
  }
  return list;
}

std::string xdmf(const Grid& grid, const std::filesystem::path& run_file,
                 const std::vector<double>& times, bool has_material,
                 const std::vector<SidecarField>& fields) {
  const std::string file = xml(run_file.filename().string());
  const Vec2 first = grid.position(0, 0);
  std::string text =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n <Domain>\n"
      "  <Grid Name=\"plate\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t record = 0; record < times.size(); ++record) {
    fmt::format_to(std::back_inserter(text),
                   R"(   <Grid Name="plate" GridType="Uniform">
      <Time Value="{}"/>
      <Topology TopologyType="3DCoRectMesh" Dimensions="1 {} {}"/>
      <Geometry GeometryType="ORIGIN_DXDYDZ">
        <DataItem Dimensions="3" NumberType="Float" Precision="8" Format="XML">0 {} {}</DataItem>
        <DataItem Dimensions="3" NumberType="Float" Precision="8" Format="XML">{} {} {}</DataItem>
      </Geometry>
)",
                   times[record], grid.ny, grid.nx, first.y(), first.x(), grid.dx, grid.dx,
                   grid.dx);
    const std::string source = file + ":/" + record_group(record);
    for (const SidecarField& field : fields) text += attribute(grid, source, field);
    if (has_material) text += material_attribute(grid, file);
    text += "   </Grid>\n";
  }
  return text + "  </Grid>\n </Domain>\n</Xdmf>\n";
}

}  // namespace hackle
