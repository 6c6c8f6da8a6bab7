// SPDX-License-Identifier: MIT
#include "study/fit_report.hpp"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/units.hpp"
#include "study/table.hpp"
#include "study/value_text.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

std::string deviation_of(const FittedParameter& one) {
  return one.uncertainty ? quantity(*one.uncertainty, one.unit) : "-";
}

Json optional_number(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json json_of(const FittedParameter& one) {
  return {{"value", one.value},       {"unit", one.unit},
          {"set", one.text},          {"uncertainty", optional_number(one.uncertainty)},
          {"at_bound", one.at_bound}, {"reacts", one.reacts}};
}

Json json_of(const FittedMeasurement& one) {
  return {{"measured", json_of(one.measured)},
          {"got", json_of(one.got)},
          {"unit", one.row.unit},
          {"sigma", one.sigma},
          {"residual", optional_number(one.residual)},
          {"reacts_to", one.reacts}};
}

Json json_of(const std::vector<FitValley>& valleys) {
  Json all = Json::array();
  for (const FitValley& one : valleys)
    all.push_back({{"settings", one.settings}, {"chi_squared", one.chi_squared}});
  return all;
}

Table parameters_table(const FitResult& result) {
  Table table{{"parameter", "value", "+-", "--set"}, {}};
  for (const FittedParameter& one : result.parameters)
    table.rows.push_back({one.key, quantity(one.value, one.unit), deviation_of(one),
                          fmt::format("{}={}", one.key, one.text)});
  return table;
}

Table residuals_table(const FitResult& result) {
  Table table{{"quantity", "measured", "got", "sigma", "residual/sigma"}, {}};
  for (const FittedMeasurement& one : result.residuals)
    table.rows.push_back({std::string(one.row.name), text_of(one.measured, one.row),
                          text_of(one.got, one.row), quantity(one.sigma, one.row.unit),
                          one.residual ? fmt::format("{:.2g}", *one.residual) : "-"});
  return table;
}

Table numbers_of(const FitResult& result) {
  Table table{{"parameter", "unit", "value", "uncertainty"}, {}};
  for (const FittedParameter& one : result.parameters)
    table.rows.push_back({one.key, one.unit, shortest(one.value),
                          one.uncertainty ? shortest(*one.uncertainty) : ""});
  return table;
}

std::string text_of(const FitResult& result) {
  std::string text =
      fmt::format("{}\n{}", aligned(parameters_table(result)), aligned(residuals_table(result)));
  for (const std::string& line : remarks_of(result))
    fmt::format_to(std::back_inserter(text), "- {}\n", hanging(line, 2, 80));
  fmt::format_to(std::back_inserter(text),
                 "chi^2 {:.3g} for {} degrees of freedom; {} rounds, {} new runs\n",
                 result.chi_squared, result.degrees_of_freedom, result.rounds, result.runs);
  return text;
}

}  // namespace

std::vector<std::string> remarks_of(const FitResult& result) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < result.parameters.size(); ++k) {
    const FittedParameter& one = result.parameters[k];
    if (!one.reacts)
      lines.push_back(fmt::format(
          "nothing that was measured reacts to {}: it is not determined by this", one.key));
    else if (one.at_bound)
      lines.push_back(fmt::format("{} ends at a bound of its range: widen it", one.key));
    else if (!one.uncertainty)
      lines.push_back(fmt::format("{} is not told apart from the others by this", one.key));
    for (const FittedMeasurement& measured : result.residuals)
      if (one.reacts && !measured.reacts[k])
        lines.push_back(fmt::format("{} does not react to {}", measured.row.name, one.key));
  }
  for (const FittedMeasurement& one : result.residuals)
    if (one.residual && std::abs(*one.residual) > 3.0)
      lines.push_back(fmt::format("{} stays {:.2g} sigma off", one.row.name, *one.residual));
  for (const FitValley& valley : result.valleys)
    lines.push_back(fmt::format(
        "another valley fits about as well: {} (chi^2 {:.3g}); --start or more measurements decide",
        name_of(valley.settings), valley.chi_squared));
  if (!result.converged)
    lines.push_back(
        fmt::format("it still improved after {} rounds: more may help (--rounds)", result.rounds));
  return lines;
}

Json to_json(const FitResult& result) {
  Json parameters = Json::object(), residuals = Json::object();
  for (const FittedParameter& one : result.parameters) parameters[one.key] = json_of(one);
  for (const FittedMeasurement& one : result.residuals)
    residuals[std::string(one.row.name)] = json_of(one);
  return {{"schema", 1},
          {"kind", "fit"},
          {"parameters", std::move(parameters)},
          {"residuals", std::move(residuals)},
          {"chi_squared", result.chi_squared},
          {"degrees_of_freedom", result.degrees_of_freedom},
          {"rounds", result.rounds},
          {"converged", result.converged},
          {"valleys", json_of(result.valleys)},
          {"runs", result.runs}};
}

StudyFindings findings_of(const FitResult& result) {
  return {"fit", text_of(result), numbers_of(result), {}, {}};
}

}  // namespace hackle
