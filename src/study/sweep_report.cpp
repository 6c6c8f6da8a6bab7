// SPDX-License-Identifier: MIT
#include "study/sweep_report.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/units.hpp"
#include "study/value_text.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

std::string setting_of(const SweepRun& run, const std::string& key) {
  const auto found = run.outcome.setting.settings.find(key);
  return found == run.outcome.setting.settings.end() ? "" : found->second;
}

// "G0" for "material.G0".
std::string short_name(const std::string& key) {
  return key.substr(key.rfind('.') + 1);
}

std::vector<QuantityRow> rows_to_show(const Sweep& sweep) {
  std::vector<QuantityRow> rows;
  for (const QuantityRow& row : sweep.quantities) {
    const auto is_found = [&](const SweepRun& run) { return value_of(run.outcome, row).found(); };
    if (row.kind != ComparedAs::paths && row.kind != ComparedAs::field &&
        std::ranges::any_of(sweep.runs, is_found))
      rows.push_back(row);
  }
  return rows;
}

// Measures of work stand last.
std::vector<std::string> cells_of(const Sweep& sweep, const SweepRun& run,
                                  const std::vector<QuantityRow>& rows) {
  std::vector<std::string> cells;
  for (const Parameter& parameter : sweep.parameters)
    cells.push_back(setting_of(run, parameter.key));
  if (cells.empty()) cells.emplace_back("as written");
  for (const QuantityRow& row : rows)
    cells.push_back(run.outcome.finished() ? text_of(value_of(run.outcome, row), row) : "failed");
  cells.push_back(quantity(run.outcome.wall, "s"));
  return cells;
}

Table table_with(const Sweep& sweep, const std::vector<QuantityRow>& rows) {
  Table table;
  for (const Parameter& parameter : sweep.parameters)
    table.heads.push_back(short_name(parameter.key));
  if (table.heads.empty()) table.heads.emplace_back("settings");
  for (const QuantityRow& row : rows) table.heads.emplace_back(row.name);
  table.heads.emplace_back("wall");
  for (const SweepRun& run : sweep.runs) table.rows.push_back(cells_of(sweep, run, rows));
  return table;
}

// Errors go before details of forks, places and energies, then the last.
std::vector<QuantityRow>::iterator least_wanted(std::vector<QuantityRow>& rows) {
  const auto is_error = std::ranges::find(rows, true, &QuantityRow::is_error);
  if (is_error != rows.end()) return is_error;
  for (const std::string_view name :
       {"fork.angle", "first_bond.place", "fork.place", "energy.broken", "arrival.time"})
    if (const auto row = std::ranges::find(rows, name, &QuantityRow::name);
        row != rows.end() && row != rows.begin())
      return row;
  return rows.end() - 1;
}

void bring_to_front(std::vector<QuantityRow>& rows, const QuantityRow& wanted) {
  const auto row = std::ranges::find(rows, wanted.name, &QuantityRow::name);
  if (row != rows.end())
    std::rotate(rows.begin(), row, row + 1);
  else
    rows.insert(rows.begin(), wanted);
}

std::size_t width_of(const Table& table) {
  const std::string text = aligned(table);
  std::size_t widest = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    widest = std::max(widest, to - from);
    from = to + 1;
  }
  return widest;
}

Json optional_json_of(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json json_of(const Sweep& sweep, const SweepRun& run) {
  Json quantities = Json::object();
  for (const QuantityRow& row : sweep.quantities)
    quantities[std::string(row.name)] = json_of(value_of(run.outcome, row));
  Json json{{"settings", run.outcome.setting.settings}, {"quantities", std::move(quantities)}};
  if (!run.outcome.finished()) json["failed"] = run.outcome.reason;
  json["wall_s"] = run.outcome.wall;
  json["cpu_s"] = run.outcome.cpu;
  return json;
}

Json json_of(const Threshold& threshold) {
  return {{"condition", threshold.condition.text},
          {"parameter", threshold.key},
          {"holds_at", optional_json_of(threshold.holds_at)},
          {"fails_at", optional_json_of(threshold.fails_at)},
          {"several_changes", threshold.several}};
}

}  // namespace

Table table_of(const Sweep& sweep, std::size_t columns) {
  std::vector<QuantityRow> rows = rows_to_show(sweep);
  if (sweep.threshold) bring_to_front(rows, sweep.threshold->condition.row);
  Table table = table_with(sweep, rows);
  while (columns > 0 && rows.size() > 1 && width_of(table) > columns) {
    rows.erase(least_wanted(rows));
    table = table_with(sweep, rows);
  }
  return table;
}

Table numbers_of(const Sweep& sweep) {
  Table table;
  for (const Parameter& parameter : sweep.parameters)
    table.heads.push_back(parameter.unit.empty()
                              ? parameter.key
                              : fmt::format("{}_{}", parameter.key, parameter.unit));
  const std::vector<QuantityRow> rows = rows_to_show(sweep);
  for (const QuantityRow& row : rows)
    if (row.kind == ComparedAs::place)
      for (const char axis : {'x', 'y'})
        table.heads.push_back(fmt::format("{}.{}_m", row.name, axis));
    else
      table.heads.push_back(column_of(row));
  table.heads.insert(table.heads.end(), {"wall_s", "cpu_s", "failed"});
  const auto number = [](const std::optional<double>& value) {
    return value ? shortest(*value) : "";
  };
  for (const SweepRun& run : sweep.runs) {
    std::vector<std::string>& cells = table.rows.emplace_back();
    for (std::size_t k = 0; k < sweep.parameters.size(); ++k)
      cells.push_back(run.numbers[k] ? shortest(*run.numbers[k])
                                     : setting_of(run, sweep.parameters[k].key));
    for (const QuantityRow& row : rows) {
      const QuantityValue value = value_of(run.outcome, row);
      if (row.kind == ComparedAs::place) {
        cells.push_back(value.place ? shortest(value.place->x()) : "");
        cells.push_back(value.place ? shortest(value.place->y()) : "");
      } else {
        cells.push_back(number(value.number));
      }
    }
    cells.insert(cells.end(), {shortest(run.outcome.wall), shortest(run.outcome.cpu),
                               run.outcome.finished() ? "" : run.outcome.reason});
  }
  return table;
}

std::string text_of(const Threshold& threshold) {
  const auto value = [&](const std::optional<double>& number) {
    return quantity(*number, threshold.unit);
  };
  if (!threshold.found())
    return fmt::format("no threshold: {} {} wherever it was looked at", threshold.condition.text,
                       threshold.holds_at ? "holds" : "does not hold");
  return fmt::format("{} holds at {} {}, not at {}{}", threshold.condition.text, threshold.key,
                     value(threshold.holds_at), value(threshold.fails_at),
                     threshold.several
                         ? "; it changes more than once along the range: this is the first change"
                         : "");
}

std::string text_of(const Sweep& sweep, std::size_t columns) {
  std::string text = aligned(table_of(sweep, columns));
  for (const SweepRun& run : sweep.runs)
    if (!run.outcome.finished())
      fmt::format_to(std::back_inserter(text), "- {} failed: {}\n",
                     name_of(run.outcome.setting.settings), run.outcome.reason);
  if (sweep.threshold)
    fmt::format_to(std::back_inserter(text), "{}\n", hanging(text_of(*sweep.threshold), 2, 80));
  return text;
}

Json to_json(const Sweep& sweep) {
  Json runs = Json::array(), parameters = Json::array();
  for (const SweepRun& run : sweep.runs) runs.push_back(json_of(sweep, run));
  for (const Parameter& parameter : sweep.parameters)
    parameters.push_back({{"key", parameter.key}, {"unit", parameter.unit}});
  Json json{{"schema", 1},
            {"kind", "sweep"},
            {"parameters", std::move(parameters)},
            {"runs", std::move(runs)},
            {"runs_made", sweep.runs_made}};
  if (sweep.threshold) json["threshold"] = json_of(*sweep.threshold);
  return json;
}

}  // namespace hackle
