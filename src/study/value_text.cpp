// SPDX-License-Identifier: MIT
#include "study/value_text.hpp"

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

Json pair_of(const Vec2& place) {
  return {place.x(), place.y()};
}

std::string place_text(const Vec2& place) {
  const PrefixedUnit unit = prefixed(place.cwiseAbs().maxCoeff(), "m");
  return fmt::format("({:.4g}, {:.4g}) {}", place.x() / unit.factor, place.y() / unit.factor,
                     unit.name);
}

}  // namespace

std::string text_of(const QuantityValue& value, const QuantityRow& row) {
  if (value.number) return quantity(*value.number, row.unit);
  if (value.place) return place_text(*value.place);
  if (value.paths.size() == 1) return "1 path";
  if (!value.paths.empty()) return fmt::format("{} paths", value.paths.size());
  return value.field.empty() ? "-" : "a field";
}

Json json_of(const QuantityValue& value) {
  if (value.number) return *value.number;
  if (value.place) return pair_of(*value.place);
  if (!value.found()) return nullptr;
  Json list = Json::array();
  for (const Line& line : value.paths) {
    Json points = Json::array();
    for (const Vec2& point : line) points.push_back(pair_of(point));
    list.push_back(std::move(points));
  }
  for (const auto& vector : value.field) list.push_back(vector ? pair_of(*vector) : Json());
  return list;
}

std::string column_of(const QuantityRow& row) {
  if (row.unit.empty()) return std::string(row.name);
  const std::size_t slash = row.unit.find('/');
  if (slash == std::string_view::npos) return fmt::format("{}_{}", row.name, row.unit);
  return fmt::format("{}_{}_per_{}", row.name, row.unit.substr(0, slash),
                     row.unit.substr(slash + 1));
}

}  // namespace hackle
