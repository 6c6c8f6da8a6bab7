// SPDX-License-Identifier: MIT
#include "store/xdmf.hpp"

#include <iterator>

#include <fmt/format.h>

namespace hackle {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

// One record of a field: row `record` of a dataset of `records` rows.
std::string attribute(const Grid& grid, const std::string& file, const char* name, int components,
                      std::size_t record, std::size_t records) {
  const std::string last = components == 1 ? "" : fmt::format(" {}", components);
  const std::string zeros = components == 1 ? "" : " 0", ones = components == 1 ? "" : " 1";
  return fmt::format(
      R"(      <Attribute Name="{name}" AttributeType="{type}" Center="Node">
        <DataItem ItemType="HyperSlab" Dimensions="1 {ny} {nx}{last}" Type="HyperSlab">
          <DataItem Dimensions="3 {rank}" Format="XML">{record} 0{zeros} 1 1{ones} 1 {nodes}{last}</DataItem>
          <DataItem Dimensions="{records} {nodes}{last}" NumberType="Float" Precision="4" Format="HDF">{file}:/{name}</DataItem>
        </DataItem>
      </Attribute>
)",
      fmt::arg("name", name), fmt::arg("type", components == 1 ? "Scalar" : "Vector"),
      fmt::arg("ny", grid.ny), fmt::arg("nx", grid.nx), fmt::arg("last", last),
      fmt::arg("rank", components == 1 ? 2 : 3), fmt::arg("record", record),
      fmt::arg("zeros", zeros), fmt::arg("ones", ones), fmt::arg("nodes", grid.nodes()),
      fmt::arg("records", records), fmt::arg("file", file));
}

}  // namespace

std::string xdmf(const Grid& grid, const std::filesystem::path& run_file,
                 const std::vector<double>& times) {
  const std::string file = escaped(run_file.filename().string());
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
    text += attribute(grid, file, "damage", 1, record, times.size());
    text += attribute(grid, file, "displacement", 3, record, times.size());
    text += attribute(grid, file, "velocity", 3, record, times.size());
    text += "   </Grid>\n";
  }
  return text + "  </Grid>\n </Domain>\n</Xdmf>\n";
}

}  // namespace hackle
