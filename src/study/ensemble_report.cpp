// SPDX-License-Identifier: MIT
#include "study/ensemble_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t page_width = 80;

std::string change_of(const Ensemble& all) {
  if (all.change == Change::own_scatter) return "another seed of the plate's scatter";
  if (all.change == Change::strength)
    return fmt::format("a scatter of strength of {:.3g} %", 100.0 * all.size);
  return fmt::format("a change of {}E by at most {:.2g}", all.of_bits ? "the last bits of " : "",
                     all.size);
}

std::string place_text(const Vec2& place) {
  return fmt::format("({:.3g}, {:.3g}) mm", 1e3 * place.x(), 1e3 * place.y());
}

std::string distance_text(double distance) {
  return std::isfinite(distance) ? quantity(distance, "m") : "as far as can be";
}

std::vector<std::string_view> names_of(const Ensemble& all, bool settled) {
  std::vector<std::string_view> names;
  for (const QuantityStatistic& one : all.quantities)
    if (one.statistic.count > 0 && one.is_settled() == settled) names.push_back(one.row.name);
  return names;
}

std::string agreement_text(const Ensemble& all) {
  const std::string end = quantity(all.scene.duration, "s");
  if (!all.has_cracks()) return fmt::format("No crack grew in any run until {}.", end);
  if (!all.parting)
    return fmt::format(
        "{}: under {} all {} runs have the same paths to the end, {}, to within {}; they are at "
        "most {} apart.",
        all.change == Change::stiffness ? "Not chaotic" : "Not sensitive", change_of(all),
        all.runs.size(), end, quantity(all.within, "m"), distance_text(all.apart));
  return fmt::format(
      "{} from {} on: until then all {} paths agree within {}, then {} moves them, first at {}. At "
      "the end, {}, they are up to {} apart.",
      all.is_chaotic() ? "Chaotic" : "Sensitive", quantity(all.parting->time, "s"), all.runs.size(),
      quantity(all.within, "m"), change_of(all), place_text(all.parting->place), end,
      distance_text(all.apart));
}

std::string trust_text(const Ensemble& all) {
  const auto settled = names_of(all, true), open = names_of(all, false);
  std::string text;
  if (!settled.empty())
    text = fmt::format("One run tells (deviation below 1 %): {}.", comma_list(settled));
  if (!open.empty())
    text += fmt::format("{}Only the distribution means something: {}.", text.empty() ? "" : " ",
                        comma_list(open));
  return text;
}

Json numbers_json(const QuantityStatistic& one) {
  Json values = Json::array();
  for (const auto& value : one.values) values.push_back(value ? Json(*value) : Json());
  const Statistic& s = one.statistic;
  return {{"unit", one.row.unit}, {"found", s.count}, {"mean", s.mean},
          {"sd", s.sd},           {"low", s.low},     {"high", s.high},
          {"min", s.min},         {"max", s.max},     {"settled", one.is_settled()},
          {"values", values}};
}

Json or_null(double distance) {
  return std::isfinite(distance) ? Json(distance) : Json();
}

std::string_view name_of(Change change) {
  if (change == Change::stiffness) return "stiffness";
  return change == Change::strength ? "strength" : "own_scatter";
}

// Three digits, in units of a picture.
std::string short_cell(double value, std::string_view unit) {
  const auto rounded = [](double number) {
    return std::strtod(fmt::format("{:.2e}", number).c_str(), nullptr);
  };
  if (unit == "m2") return quantity(rounded(1e6 * value), "mm2");
  if (unit == "rad") return quantity(rounded(value * 180.0 / std::numbers::pi), "deg");
  return quantity(rounded(value), unit);
}

Table statistics_of(const Ensemble& ensemble) {
  Table table{{"quantity", "mean", "± 95 %", "sd", "min", "max", "runs"}, {}};
  for (const QuantityStatistic& one : ensemble.quantities) {
    const Statistic& s = one.statistic;
    if (s.count == 0) continue;
    const auto cell = [&](double value) { return short_cell(value, one.row.unit); };
    table.rows.push_back({std::string(one.row.name), cell(s.mean), cell(s.high - s.mean),
                          cell(s.sd), cell(s.min), cell(s.max), fmt::format("{}", s.count)});
  }
  return table;
}

}  // namespace

std::string verdict_of(const Ensemble& ensemble) {
  std::string text = agreement_text(ensemble) + "\n" + trust_text(ensemble) + "\n";
  if (ensemble.change == Change::stiffness && ensemble.has_cracks())
    text += "A symmetric scene stays so under these changes; --scatter 1% ends that.\n";
  for (const Outcome& one : ensemble.failed)
    text += fmt::format("The run with {} did not finish: {}\n", name_of(one.setting.settings),
                        one.reason);
  return text;
}

std::string text_of(const Ensemble& ensemble) {
  return fmt::format("{}\n{}\nThe mean lies within its bounds with 95 % (Student's t).\n",
                     fitted(verdict_of(ensemble), page_width), aligned(statistics_of(ensemble)));
}

Table table_of(const Ensemble& ensemble) {
  Table table{{"run", "settings"}, {}};
  for (const QuantityStatistic& one : ensemble.quantities)
    table.heads.push_back(one.row.unit.empty()
                              ? std::string(one.row.name)
                              : fmt::format("{} ({})", one.row.name, one.row.unit));
  for (std::size_t run = 0; run < ensemble.runs.size(); ++run) {
    auto& row = table.rows.emplace_back();
    row = {fmt::format("{}", run), name_of(ensemble.runs[run].setting.settings)};
    for (const QuantityStatistic& one : ensemble.quantities)
      row.push_back(one.values[run] ? shortest(*one.values[run]) : "");
  }
  return table;
}

Json to_json(const Ensemble& ensemble) {
  Json json{{"schema", 1}, {"kind", "ensemble"}, {"runs", ensemble.runs.size()}};
  json["failed"] = ensemble.failed.size();
  json["change"] = name_of(ensemble.change);
  json["size"] = ensemble.size;
  json["chaotic"] = ensemble.is_chaotic();
  json["agree_until_s"] = ensemble.parting ? ensemble.parting->time : ensemble.scene.duration;
  json["agree_to_the_end"] = !ensemble.parting;
  json["agree_within_m"] = ensemble.within;
  if (ensemble.parting)
    json["parting_m"] = {ensemble.parting->place.x(), ensemble.parting->place.y()};
  json["apart_m"] = or_null(ensemble.apart);
  json["verdict"] = verdict_of(ensemble);
  Json& quantities = json["quantities"] = Json::object();
  for (const QuantityStatistic& one : ensemble.quantities)
    if (one.statistic.count > 0) quantities[std::string(one.row.name)] = numbers_json(one);
  return json;
}

Diagram chart_of(const Ensemble& ensemble) {
  Diagram diagram;
  diagram.title = fmt::format("How far {} runs are from the first", ensemble.runs.size());
  diagram.x = {.name = "time", .unit = "s", .range = {}};
  diagram.y = {.name = "distance of the paths", .unit = "m", .range = {}};
  diagram.curves = {{.name = "largest", .points = ensemble.largest},
                    {.name = "median", .points = ensemble.median}};
  diagram.levels = {{"agree within", ensemble.within}};
  return diagram;
}

}  // namespace hackle
