// SPDX-License-Identifier: MIT
#include "output/report/field_sample.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "measure/between_nodes.hpp"

namespace hackle {
namespace {

constexpr int boxes_along_longer_side = 40;

SampledField sampled(const View& view) {
  const double width = view.plate().width, height = view.plate().height;
  const double box = std::max(width, height) / boxes_along_longer_side;
  SampledField field;
  field.time = view.time();
  field.columns = std::max(1, static_cast<int>(std::lround(width / box)));
  field.rows = std::max(1, static_cast<int>(std::lround(height / box)));
  for (int row = 0; row < field.rows; ++row)
    for (int column = 0; column < field.columns; ++column) {
      const Vec2 place((column + 0.5) * width / field.columns, (row + 0.5) * height / field.rows);
      std::optional<Vec2>& value = field.displacements.emplace_back();
      if (const auto nodes = surrounding(view, place))
        value = interpolated(*nodes, [&](int i, int j) { return view.displacement(i, j); });
    }
  return field;
}

}  // namespace

bool FieldSampler::due(const Simulation& simulation) {
  return !field_ && simulation.time() >= time_;
}

double FieldSampler::moment(const Simulation& simulation) {
  return std::max(time_, simulation.time() - simulation.dt());
}

void FieldSampler::observe(const Simulation& simulation) {
  field_ = sampled(simulation.view());
}

nlohmann::ordered_json to_json(const SampledField& field) {
  nlohmann::ordered_json json{
      {"time_s", field.time}, {"columns", field.columns}, {"rows", field.rows}};
  auto& list = json["displacements_m"] = nlohmann::ordered_json::array();
  for (const std::optional<Vec2>& value : field.displacements)
    list.push_back(value ? nlohmann::ordered_json{value->x(), value->y()}
                         : nlohmann::ordered_json());
  return json;
}

}  // namespace hackle
