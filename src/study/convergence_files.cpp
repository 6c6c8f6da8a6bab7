// SPDX-License-Identifier: MIT
#include "study/convergence_files.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"
#include "study/convergence_report.hpp"
#include "study/value_text.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json json_of(const QuantityConvergence& one) {
  Json values = Json::array(), distances = Json::array();
  for (std::size_t k = 0; k < one.values.size(); ++k) {
    values.push_back(is_by_distance(one.row) ? optional_json(one.distances[k])
                                             : json_of(one.values[k]));
    distances.push_back(optional_json(one.distances[k]));
  }
  Json json{{"unit", one.row.unit},
            {"values", std::move(values)},
            {"distances", std::move(distances)},
            {"order", optional_json(one.order.order)},
            {"richardson",
             one.place ? json_of(QuantityValue{.place = one.place}) : optional_json(one.limit)},
            {"gci", optional_json(one.gci)},
            {"uncertainty", optional_json(one.order.uncertainty)},
            {"per_halving", optional_json(one.order.per_halving)},
            {"exponent", optional_json(one.exponent)},
            {"verdict", name_of(one.order.trend)}};
  return json;
}

Json json_of(const ConvergenceAxis& axis) {
  Json levels = Json::array(), left_out = Json::array(), quantities = Json::object();
  for (const Level& level : axis.levels)
    levels.push_back({{"name", level.name},
                      {"size", level.size},
                      {"spacing_m", level.spacing},
                      {"dt_s", level.dt},
                      {"settings", level.outcome.setting.settings},
                      {"wall_s", level.outcome.wall},
                      {"cpu_s", level.outcome.cpu}});
  for (const LeftOutLevel& level : axis.left_out)
    left_out.push_back({{"name", level.name}, {"expected_cpu_s", level.expected}});
  for (const QuantityConvergence& one : axis.quantities)
    quantities[std::string(one.row.name)] = json_of(one);
  return {{"axis", name_of(axis.by)},
          {"levels", std::move(levels)},
          {"left_out", std::move(left_out)},
          {"failed", axis.failed},
          {"quantities", std::move(quantities)}};
}

// What a chart tells apart: a colour each.
constexpr std::size_t most_curves = 5;

std::string title_of(const ConvergenceAxis& axis) {
  return fmt::format("{}-convergence", name_of(axis.by));
}

DiagramAxis size_axis(const ConvergenceAxis& axis, bool logarithmic) {
  const bool is_step = axis.by == RefinedBy::step;
  return {std::string(refined_name(axis.by)), is_step ? "s" : "m", {}, logarithmic};
}

DiagramCurve error_curve(const ConvergenceAxis& axis, const QuantityConvergence& one) {
  DiagramCurve curve{std::string(one.row.name), {}};
  const double finest = one.values.back().number.value_or(0.0);
  const double scale = has_relative_error(one.row) ? std::abs(finest) : 1.0;
  for (std::size_t k = 0; k + 1 < axis.levels.size(); ++k)
    if (one.distances[k] && *one.distances[k] > 0.0 && scale > 0.0)
      curve.points.emplace_back(axis.levels[k].size, *one.distances[k] / scale);
  return curve;
}

bool is_length(const QuantityRow& row) {
  return row.kind == ComparedAs::place || row.kind == ComparedAs::paths;
}

// Returns diagrams with a few of the curves each.
std::vector<Diagram> divided(Diagram whole) {
  std::vector<Diagram> parts;
  for (std::size_t from = 0; from < whole.curves.size(); from += most_curves) {
    Diagram& part = parts.emplace_back(whole);
    const auto first = whole.curves.begin() + static_cast<long>(from);
    const auto count = std::min(most_curves, whole.curves.size() - from);
    part.curves.assign(first, first + static_cast<long>(count));
  }
  return parts;
}

}  // namespace

Json to_json(const ConvergenceStudy& study) {
  Json axes = Json::array();
  for (const ConvergenceAxis& axis : study.axes) axes.push_back(json_of(axis));
  return {{"schema", 1},
          {"kind", "convergence"},
          {"sample_at_s", study.sample_at},
          {"runs", study.runs},
          {"axes", std::move(axes)}};
}

Table numbers_of(const ConvergenceStudy& study) {
  Table table{{"axis", "quantity", "unit", "size", "spacing_m", "dt_s", "value", "x_m", "y_m",
               "distance_to_finest"},
              {}};
  const auto number = [](const std::optional<double>& value) {
    return value ? shortest(*value) : "";
  };
  for (const ConvergenceAxis& axis : study.axes)
    for (const QuantityConvergence& one : axis.quantities)
      for (std::size_t k = 0; k < axis.levels.size(); ++k) {
        const auto& place = one.values[k].place;
        table.rows.push_back({std::string(name_of(axis.by)), std::string(one.row.name),
                              std::string(one.row.unit), shortest(axis.levels[k].size),
                              shortest(axis.levels[k].spacing), shortest(axis.levels[k].dt),
                              number(one.values[k].number), place ? shortest(place->x()) : "",
                              place ? shortest(place->y()) : "", number(one.distances[k])});
      }
  return table;
}

Diagram errors_of(const ConvergenceAxis& axis) {
  Diagram diagram{.title = title_of(axis), .x = size_axis(axis, true)};
  diagram.y = {"distance to the finest, as a share", "", {}, true};
  for (const QuantityConvergence& one : axis.quantities)
    if (!is_length(one.row) && one.row.kind != ComparedAs::count)
      if (DiagramCurve curve = error_curve(axis, one); !curve.points.empty())
        diagram.curves.push_back(std::move(curve));
  return diagram;
}

Diagram moves_of(const ConvergenceAxis& axis) {
  Diagram diagram{.title = title_of(axis), .x = size_axis(axis, true)};
  diagram.y = {"distance to the finest", "m", {}, true};
  for (const QuantityConvergence& one : axis.quantities)
    if (is_length(one.row))
      if (DiagramCurve curve = error_curve(axis, one); !curve.points.empty())
        diagram.curves.push_back(std::move(curve));
  return diagram;
}

Diagram values_of(const ConvergenceAxis& axis) {
  Diagram diagram{.title = title_of(axis), .x = size_axis(axis, false)};
  diagram.y = {"value over that at the finest level", ""};
  for (const QuantityConvergence& one : axis.quantities) {
    const double finest = one.values.back().number.value_or(0.0);
    if (finest == 0.0 || !has_relative_error(one.row)) continue;
    DiagramCurve curve{std::string(one.row.name), {}};
    for (std::size_t k = 0; k < axis.levels.size(); ++k)
      if (const auto& number = one.values[k].number)
        curve.points.emplace_back(axis.levels[k].size, *number / finest);
    diagram.curves.push_back(std::move(curve));
  }
  return diagram;
}

StudyFindings findings_of(const ConvergenceStudy& study) {
  StudyFindings findings{"convergence", text_of(study), numbers_of(study), {}, {}};
  const auto draw = [&](const Diagram& whole, const ConvergenceAxis& axis, const char* what) {
    int number = 0;
    for (Diagram& part : divided(whole)) {
      const std::string count = ++number > 1 ? fmt::format("-{}", number) : "";
      findings.diagram_names.push_back(fmt::format("{}-{}{}", name_of(axis.by), what, count));
      findings.diagrams.push_back(std::move(part));
    }
  };
  for (const ConvergenceAxis& axis : study.axes) {
    draw(errors_of(axis), axis, "error");
    draw(moves_of(axis), axis, "places");
    draw(values_of(axis), axis, "values");
  }
  return findings;
}

}  // namespace hackle
