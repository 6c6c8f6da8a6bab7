// SPDX-License-Identifier: MIT
#include "study/trade_report.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/units.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

constexpr double rounding = 1e-9;  // of what counts as one

std::string error_cell(const Errors& errors, const QuantityRow& row, const Trade& trade) {
  const auto at = errors.find(std::string(row.name));
  if (at == errors.end()) return "";
  if (!at->second) return "lost";
  const bool is_none = *at->second < rounding * trade.allowed.at(at->first);
  return is_none ? "0" : quantity(*at->second, row.unit);
}

std::string speed_of(const Outcome& outcome) {
  if (!outcome.finished()) return "";
  return fmt::format("{:.1f}", 1e-6 * outcome.told["node_steps_per_s"].get<double>());
}

std::string memory_of(const Outcome& outcome) {
  return fmt::format("{:.0f}", 1e-6 * static_cast<double>(outcome.peak_bytes));
}

// The numbers of the runs, those on the front first, by cost.
std::vector<std::size_t> by_cost(const Trade& trade, bool only_front) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < trade.runs.size(); ++k)
    if (!only_front || trade.runs[k].on_front || k == 0) order.push_back(k);
  std::ranges::sort(order, {}, [&](std::size_t k) { return trade.runs[k].outcome.cpu; });
  return order;
}

// The quantities that a narrow table has room for: the first that any run tells of.
std::vector<QuantityRow> main_quantities(const Trade& trade) {
  constexpr std::size_t room = 3;
  constexpr auto preferred = std::to_array<std::string_view>(
      {"displacement", "tip.path", "fork.time", "first_bond.time", "crack.length"});
  std::vector<QuantityRow> rows;
  const auto known = [&](const QuantityRow& row) {
    return trade.runs.front().errors.contains(std::string(row.name));
  };
  for (const std::string_view name : preferred)
    for (const QuantityRow& row : trade.quantities)
      if (row.name == name && known(row)) rows.push_back(row);
  for (const QuantityRow& row : trade.quantities)
    if (known(row) && std::ranges::find(preferred, row.name) == preferred.end())
      rows.push_back(row);
  rows.resize(std::min(rows.size(), room), QuantityRow{});
  return rows;
}

Table front_table(const Trade& trade) {
  const std::vector<QuantityRow> rows = main_quantities(trade);
  Table table{{"CPU s", "error"}, {}};
  for (const QuantityRow& row : rows) table.heads.emplace_back(row.name);
  table.heads.emplace_back("front");
  const auto add = [&](const std::string& name, const TradeRun& run) {
    std::vector<std::string> cells{fmt::format("{:.2f}", run.outcome.cpu),
                                   fmt::format("{:.2f}", run.error)};
    for (const QuantityRow& row : rows) cells.push_back(error_cell(run.errors, row, trade));
    cells.push_back(name);
    table.rows.push_back(std::move(cells));
  };
  for (const std::size_t k : by_cost(trade, true)) {
    const TradeRun& run = trade.runs[k];
    add(name_of(run.settings) + (run.on_front ? "" : " (beaten)"), run);
  }
  add("reference", trade.reference);
  return table;
}

std::string noise_text(const Trade& trade) {
  std::string text;
  for (const QuantityRow& row : trade.quantities) {
    const auto at = trade.noise.find(std::string(row.name));
    if (row.is_error || at == trade.noise.end()) continue;
    if (at->second && *at->second < rounding * trade.allowed.at(at->first)) continue;
    fmt::format_to(std::back_inserter(text), "{}{} {}", text.empty() ? "" : ", ", row.name,
                   at->second ? quantity(*at->second, row.unit) : "is lost");
  }
  return text.empty()
             ? "A change in the last bits of the stiffness moves nothing above rounding.\n"
             : "A change in the last bits of the stiffness moves, as chance does: " + text + ".\n";
}

std::string bytes_text(std::uint64_t bytes) {
  return fmt::format("{:.2f}", 1e-6 * static_cast<double>(bytes));
}

std::string movie_name(const PictureCost& one) {
  if (one.settings.empty()) return "movies as written";
  return fmt::format("every {}, {} px{}", quantity(std::stod(one.settings.at("movie.every")), "s"),
                     one.settings.at("movie.width"), one.on_front ? "" : " (beaten)");
}

// What movies cost beside the run as written.
std::string pictures_text(const Trade& trade) {
  if (trade.pictures.empty()) return "";
  Table table{{"+ CPU s", "MB of files", "seen.time", "seen.place", "movies"}, {}};
  for (const PictureCost& one : trade.pictures) {
    const auto cell = [&](const char* name, const char* unit) {
      return one.errors.empty() ? "" : quantity(*one.errors.at(name), unit);
    };
    table.rows.push_back({fmt::format("{:.2f}", one.more), bytes_text(one.file_bytes),
                          cell("seen.time", "s"), cell("seen.place", "m"), movie_name(one)});
  }
  return "\n" + aligned(table) +
         "\nAn event is seen up to seen.time late, and no better than to seen.place.\n";
}

Json to_json(const QuantityValue& value) {
  if (value.number) return *value.number;
  if (value.place) return {value.place->x(), value.place->y()};
  return nullptr;
}

Json cost_json(const TradeRun& run) {
  const Outcome& outcome = run.outcome;
  Json json{{"settings", run.settings},
            {"wall_s", outcome.wall},
            {"cpu_s", outcome.cpu},
            {"bytes", outcome.peak_bytes}};
  if (outcome.finished())
    json["node_steps_per_s"] = outcome.told["node_steps_per_s"];
  else
    json["failed"] = outcome.reason;
  return json;
}

Json errors_json(const Errors& errors) {
  Json json = Json::object();
  for (const auto& [name, error] : errors) json[name] = error ? Json(*error) : Json();
  return json;
}

Json picture_json(const PictureCost& one) {
  return {{"settings", one.settings},
          {"wall_s", one.outcome.wall},
          {"cpu_s", one.outcome.cpu},
          {"bytes", one.outcome.peak_bytes},
          {"more_cpu_s", one.more},
          {"file_bytes", one.file_bytes},
          {"errors", errors_json(one.errors)},
          {"on_front", one.on_front}};
}

Json values_json(const Trade& trade, const Outcome& outcome) {
  Json json = Json::object();
  for (const QuantityRow& row : trade.quantities)
    if (Json value = to_json(value_of(outcome, row)); !value.is_null())
      json[std::string(row.name)] = std::move(value);
  return json;
}

}  // namespace

std::string text_of(const Trade& trade) {
  std::string text = aligned(front_table(trade));
  fmt::format_to(std::back_inserter(text), "\n{} runs. {}", trade.runs.size() + 1,
                 noise_text(trade));
  if (trade.screened_at > 1.0)
    fmt::format_to(std::back_inserter(text),
                   "These ways were the best of many on a lattice {:.1f} times coarser.\n",
                   trade.screened_at);
  if (trade.skipped > 0)
    fmt::format_to(
        std::back_inserter(text),
        "{} combinations were not run: by their parts they cost too much or are beaten.\n",
        trade.skipped);
  for (const Recommendation& one : trade.recommended) {
    const TradeRun& run = trade.runs[one.run];
    fmt::format_to(std::back_inserter(text), "within {} of CPU time: {} (error {:.2f})\n",
                   quantity(one.budget, "s"), name_of(run.settings), run.error);
  }
  return text + pictures_text(trade);
}

Table table_of(const Trade& trade) {
  Table table{{"settings", "wall_s", "cpu_s", "Mnode_steps_per_s", "MB", "error", "on_front"}, {}};
  for (const QuantityRow& row : trade.quantities)
    table.heads.push_back(row.unit.empty() ? std::string(row.name)
                                           : fmt::format("{} ({})", row.name, row.unit));
  const auto add = [&](const std::string& name, const TradeRun& run) {
    const Outcome& outcome = run.outcome;
    std::vector<std::string> cells{name,
                                   fmt::format("{:.3f}", outcome.wall),
                                   fmt::format("{:.3f}", outcome.cpu),
                                   speed_of(outcome),
                                   memory_of(outcome),
                                   std::isfinite(run.error) ? shortest(run.error) : "",
                                   run.on_front ? "yes" : ""};
    for (const QuantityRow& row : trade.quantities) {
      const auto at = run.errors.find(std::string(row.name));
      cells.push_back(at == run.errors.end() ? "" : at->second ? shortest(*at->second) : "lost");
    }
    table.rows.push_back(std::move(cells));
  };
  add("reference: " + name_of(trade.reference.settings), trade.reference);
  for (const std::size_t k : by_cost(trade, false))
    add(name_of(trade.runs[k].settings), trade.runs[k]);
  return table;
}

Json to_json(const Trade& trade) {
  Json json{{"schema", 1}, {"kind", "trade"}};
  json["reference"] = cost_json(trade.reference);
  json["reference"]["values"] = values_json(trade, trade.reference.outcome);
  json["allowed"] = trade.allowed;
  json["screened_at"] = trade.screened_at;
  json["noise"] = errors_json(trade.noise);
  Json& runs = json["runs"] = Json::array();
  for (const TradeRun& run : trade.runs) {
    Json one = cost_json(run);
    one["errors"] = errors_json(run.errors);
    one["error"] = std::isfinite(run.error) ? Json(run.error) : Json();
    one["on_front"] = run.on_front;
    runs.push_back(std::move(one));
  }
  Json& recommended = json["recommended"] = Json::array();
  for (const Recommendation& one : trade.recommended)
    recommended.push_back({{"budget", one.budget}, {"settings", trade.runs[one.run].settings}});
  json["skipped"] = trade.skipped;
  Json& pictures = json["pictures"] = Json::array();
  for (const PictureCost& one : trade.pictures) pictures.push_back(picture_json(one));
  return json;
}

Diagram chart_of(const Trade& trade) {
  Diagram diagram;
  diagram.title = "Error against cost";
  diagram.x = {.name = "CPU time", .unit = "s", .range = {}, .logarithmic = true};
  diagram.y = {.name = "error, in allowances", .unit = "", .range = {}, .logarithmic = true};
  DiagramCurve all{"all runs", {}, DiagramStroke::dots}, front{"front", {}, DiagramStroke::line};
  for (const std::size_t k : by_cost(trade, false)) {
    const TradeRun& run = trade.runs[k];
    if (!std::isfinite(run.error)) continue;
    all.points.emplace_back(run.outcome.cpu, run.error);
    if (run.on_front) front.points.emplace_back(run.outcome.cpu, run.error);
  }
  diagram.curves = {all, front};
  diagram.curves.push_back({"as written",
                            {Vec2(trade.runs.front().outcome.cpu, trade.runs.front().error)},
                            DiagramStroke::dots});
  int number = 0;
  for (const std::size_t k : by_cost(trade, true))
    if (trade.runs[k].on_front && k != 0)
      diagram.curves.push_back({fmt::format("{} {}", ++number, name_of(trade.runs[k].settings)),
                                {Vec2(trade.runs[k].outcome.cpu, trade.runs[k].error)},
                                DiagramStroke::dots,
                                std::to_string(number)});
  return diagram;
}

}  // namespace hackle
