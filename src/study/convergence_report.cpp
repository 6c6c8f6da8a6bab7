// SPDX-License-Identifier: MIT
#include "study/convergence_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/units.hpp"
#include "study/value_text.hpp"

namespace hackle {
namespace {

std::string optional_cell(const std::optional<double>& value, std::string_view unit) {
  return value ? quantity(*value, unit) : "-";
}

std::string percent_of(double share) {
  return fmt::format("{:.2g} %", 100.0 * share);
}

std::string gci_cell(const QuantityConvergence& one) {
  if (!one.gci) return "-";
  const bool is_share = has_relative_error(one.row) || one.row.kind == ComparedAs::field;
  return is_share ? percent_of(*one.gci) : quantity(*one.gci, one.row.unit);
}

std::string limit_cell(const QuantityConvergence& one) {
  if (one.place) return text_of({.place = one.place}, one.row);
  return optional_cell(one.limit, one.row.unit);
}

std::string value_cell(const QuantityConvergence& one, std::size_t level) {
  const QuantityValue& value = one.values[level];
  const bool is_finest = level + 1 == one.values.size();
  if (is_finest && is_by_distance(one.row) && value.found()) return "finest";
  if (value.number || is_finest || !one.values.back().found()) return text_of(value, one.row);
  return optional_cell(one.distances[level], one.row.unit);
}

bool is_settled(const QuantityConvergence& one) {
  return one.order.trend == Trend::converges || one.order.trend == Trend::constant;
}

// A bond breaks at a stretch that goes with 1/sqrt(horizon) for the same fracture energy, so what
// has no crack with a singular field, whose size does not depend on the horizon, does as well.
std::string reason_for(const ConvergenceAxis& axis, const QuantityConvergence& one) {
  if (one.row.name == "first_bond.time" && axis.by == RefinedBy::delta && one.exponent &&
      std::abs(*one.exponent + 0.5) < 0.2)
    return ": strength without a crack goes with 1/sqrt(horizon), as G0 is fixed; a crack in the "
           "scene, or a horizon taken from the strength, settles it";
  if (one.row.name == "first_bond.time" && axis.by == RefinedBy::delta)
    return "; where no crack begins it, strength goes with 1/sqrt(horizon)";
  if (one.row.kind == ComparedAs::paths || one.row.name.starts_with("fork."))
    return "; beyond the first fork the outcome hangs on last bits: compare several runs";
  return "";
}

std::string moves(const ConvergenceAxis& axis, const QuantityConvergence& one) {
  const auto& step = one.order.per_halving;
  if (!step) return "";
  const std::string size =
      one.row.kind == ComparedAs::field ? percent_of(*step) : quantity(*step, one.row.unit);
  return fmt::format("it moves by {} per halving of the {}", size, refined_name(axis.by));
}

std::string sentence_of(const ConvergenceAxis& axis, const QuantityConvergence& one) {
  const auto found = static_cast<long>(
      std::ranges::count_if(one.values, [](const QuantityValue& value) { return value.found(); }));
  switch (one.order.trend) {
    case Trend::missing:
      return fmt::format("{} is found at {} of {} levels only{}{}", one.row.name, found,
                         one.values.size(), one.order.per_halving ? "; there " : "",
                         moves(axis, one));
    case Trend::oscillates:
      return fmt::format("{} oscillates: {}{}", one.row.name, moves(axis, one),
                         one.gci ? ", less than before" : "");
    case Trend::diverges: {
      std::string text = fmt::format("{} does not converge: {}", one.row.name, moves(axis, one));
      if (one.exponent && std::abs(*one.exponent) > 0.1)
        fmt::format_to(std::back_inserter(text), ", as {}^{:.2f}", refined_name(axis.by),
                       *one.exponent);
      return text + reason_for(axis, one);
    }
    default:
      return fmt::format("{}: two levels say little; {}", one.row.name, moves(axis, one));
  }
}

constexpr std::string_view sentence_of(RefinedBy by) {
  if (by == RefinedBy::delta) return "delta: horizon and spacing together, m fixed";
  if (by == RefinedBy::m) return "m: horizon fixed, spacing by spacing";
  return "step: everything else fixed";
}

}  // namespace

Table values_table(const ConvergenceAxis& axis) {
  Table table;
  table.heads.emplace_back("quantity");
  for (const Level& level : axis.levels) table.heads.push_back(level.name);
  for (const QuantityConvergence& one : axis.quantities) {
    std::vector<std::string>& row = table.rows.emplace_back();
    row.emplace_back(one.row.name);
    for (std::size_t k = 0; k < one.values.size(); ++k) row.push_back(value_cell(one, k));
  }
  return table;
}

Table verdict_table(const ConvergenceAxis& axis) {
  Table table{{"quantity", "order", "limit", "GCI", "verdict"}, {}};
  for (const QuantityConvergence& one : axis.quantities)
    table.rows.push_back({std::string(one.row.name),
                          one.order.order ? fmt::format("{:.2f}", *one.order.order) : "-",
                          limit_cell(one), gci_cell(one), std::string(name_of(one.order.trend))});
  return table;
}

std::string text_of(const ConvergenceStudy& study) {
  constexpr std::size_t width = 80;
  std::string text;
  const auto to_text = std::back_inserter(text);
  for (const ConvergenceAxis& axis : study.axes) {
    fmt::format_to(to_text, "{}\n", sentence_of(axis.by));
    if (!axis.quantities.empty())
      fmt::format_to(to_text, "{}\n{}", aligned(values_table(axis)), aligned(verdict_table(axis)));
    for (const std::string& line : remarks_of(axis))
      fmt::format_to(to_text, "- {}\n", hanging(line, 2, width));
    text += '\n';
  }
  for (const std::string& line : remarks_of(study))
    fmt::format_to(to_text, "{}\n", hanging(line, 2, width));
  return text;
}

std::vector<std::string> remarks_of(const ConvergenceAxis& axis) {
  std::vector<std::string> lines;
  for (const QuantityConvergence& one : axis.quantities)
    if (!is_settled(one)) lines.push_back(sentence_of(axis, one));
  std::vector<std::string_view> absent;
  for (const QuantityRow& row : axis.absent) absent.push_back(row.name);
  if (!absent.empty())
    lines.push_back(fmt::format("not found at any level: {}", comma_list(absent)));
  for (const LeftOutLevel& level : axis.left_out)
    lines.push_back(
        fmt::format("left out: {}, which would take about {} of CPU time (--budget {:.0f})",
                    level.name, quantity(level.expected, "s"), std::ceil(level.expected)));
  for (const std::string& failure : axis.failed) lines.push_back("failed: " + failure);
  return lines;
}

std::vector<std::string> remarks_of(const ConvergenceStudy& study) {
  std::vector<std::string_view> settled, others;
  if (study.axes.empty()) return {};
  for (const QuantityRow& row : quantity_rows()) {
    bool is_known = false, holds = true;
    for (const ConvergenceAxis& axis : study.axes)
      for (const QuantityConvergence& one : axis.quantities)
        if (one.row.name == row.name) {
          is_known = true;
          holds = holds && is_settled(one);
        }
    if (is_known) (holds ? settled : others).push_back(row.name);
  }
  std::vector<std::string> lines;
  if (!settled.empty())
    lines.push_back(fmt::format("settled by every refinement: {}", comma_list(settled)));
  if (!others.empty())
    lines.push_back(fmt::format("not settled by every refinement: {}", comma_list(others)));
  return lines;
}

}  // namespace hackle
