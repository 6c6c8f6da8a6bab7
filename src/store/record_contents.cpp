// SPDX-License-Identifier: MIT
#include "store/record_contents.hpp"

#include <algorithm>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace hackle {
namespace {

bool is_within(const NodeWindow& nodes, const Grid& grid) {
  const auto fits_in = [&](int first, int count, int all) {
    return first >= 0 && first < all && count >= 1 && count <= 1 + (all - 1 - first) / nodes.stride;
  };
  return nodes.stride >= 1 && fits_in(nodes.i, nodes.nx, grid.nx) &&
         fits_in(nodes.j, nodes.ny, grid.ny);
}

RecordContents read_contents(const std::string& text, const Grid& grid) {
  const auto json = nlohmann::json::parse(text);
  RecordContents contents;
  contents.fields = json.at("fields").get<std::vector<std::string>>();
  NodeWindow& nodes = contents.nodes;
  json.at("first_node").at(0).get_to(nodes.i);
  json.at("first_node").at(1).get_to(nodes.j);
  json.at("nodes").at(0).get_to(nodes.nx);
  json.at("nodes").at(1).get_to(nodes.ny);
  json.at("stride").get_to(nodes.stride);
  json.at("part").get_to(contents.part);
  json.at("exact").get_to(contents.exact);
  for (const std::string& field : contents.fields)
    if (std::ranges::find(recordable_fields, field) == recordable_fields.end())
      throw std::invalid_argument("a field");
  if (!is_within(nodes, grid)) throw std::invalid_argument("nodes");
  return contents;
}

}  // namespace

bool RecordContents::holds(std::string_view field) const {
  return std::ranges::find(fields, field) != fields.end();
}

RecordContents standard_contents(const Grid& grid) {
  return {{usual_records.begin(), usual_records.end()}, {0, 0, grid.nx, grid.ny, 1}};
}

std::string text_of(const RecordContents& contents) {
  const NodeWindow& nodes = contents.nodes;
  return nlohmann::ordered_json{{"fields", contents.fields},     {"first_node", {nodes.i, nodes.j}},
                                {"nodes", {nodes.nx, nodes.ny}}, {"stride", nodes.stride},
                                {"part", contents.part},         {"exact", contents.exact}}
      .dump(2);
}

RecordContents contents_of(const Hdf5Reader& file, const Grid& grid) {
  if (!file.holds("contents")) return standard_contents(grid);
  const std::string text = file.text("contents");
  try {
    return read_contents(text, grid);
  } catch (const std::exception&) {  // its message may quote the file
    file.refuse("its contents are damaged");
  }
}

Grid grid_of(const NodeWindow& nodes, const Grid& grid) {
  const double dx = nodes.stride * grid.dx;
  const Vec2 half(0.5 * (nodes.nx - 1), 0.5 * (nodes.ny - 1));
  return {nodes.nx, nodes.ny, dx, grid.position(nodes.i, nodes.j) + dx * half};
}

}  // namespace hackle
