// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "study/features.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

bool any_counted(const std::vector<FeatureCost>& costs) {
  for (const FeatureCost& cost : costs)
    if (cost.instructions) return true;
  return false;
}

bool any_started(const std::vector<FeatureCost>& costs) {
  for (const FeatureCost& cost : costs)
    if (cost.start_cpu > 0.0) return true;
  return false;
}

// Against the base: "1.24", or "-" for the base itself.
std::string ratio(double value, double of_base) {
  return of_base > 0.0 ? fmt::format("{:.2f}", value / of_base) : "-";
}

std::string megabytes(std::int64_t bytes) {
  return fmt::format("{:.1f}", 1e-6 * static_cast<double>(bytes));
}

// Which features touch memory before the first step, and that the others do not.
std::string start_text(const std::vector<FeatureCost>& costs) {
  constexpr std::int64_t noise = 500'000;  // of where the system puts things
  std::size_t few = 0;
  std::vector<std::string> touching;
  for (std::size_t k = 1; k < costs.size(); ++k) {
    if (!costs[k].finished) continue;
    if (costs[k].start_bytes > noise)
      touching.push_back(fmt::format("{} {} MB", costs[k].name, megabytes(costs[k].start_bytes)));
    else
      ++few;
  }
  return fmt::format(
      "Start-up: {} of {} features touch less than 0.5 MB beyond the plate itself{}.\n", few,
      few + touching.size(),
      touching.empty() ? "" : fmt::format("; more: {}", fmt::join(touching, ", ")));
}

std::vector<std::string> heads_of(const std::vector<FeatureCost>& costs) {
  std::vector<std::string> heads{"feature", "CPU (s)"};
  if (any_started(costs)) heads.insert(heads.end(), {"start (ms)", "MB"});
  heads.insert(heads.end(), {"MB more", "ns/node-step", "ratio"});
  if (any_counted(costs)) heads.insert(heads.end(), {"instr.", "ratio", "start (M)"});
  return heads;
}

std::vector<std::string> cells_of(const FeatureCost& cost, const std::vector<FeatureCost>& costs) {
  const FeatureCost& first = costs.front();
  std::vector<std::string> cells{cost.name, fmt::format("{:.3f}", cost.cpu)};
  if (any_started(costs)) {
    cells.push_back(fmt::format("{:.0f}", 1e3 * cost.start_cpu));
    cells.push_back(megabytes(cost.start_bytes));
  }
  cells.push_back(megabytes(cost.bytes));
  cells.push_back(fmt::format("{:.1f}", cost.ns_per_node_step));
  cells.push_back(ratio(cost.ns_per_node_step, first.ns_per_node_step));
  if (!any_counted(costs)) return cells;
  cells.push_back(cost.instructions ? fmt::format("{:.1f}", *cost.instructions) : "-");
  cells.push_back(cost.instructions && first.instructions
                      ? fmt::format("{:.4f}", *cost.instructions / *first.instructions)
                      : "-");
  cells.push_back(cost.start_instructions ? fmt::format("{:.1f}", 1e-6 * *cost.start_instructions)
                                          : "-");
  return cells;
}

}  // namespace

std::string text_of(const std::vector<FeatureCost>& costs) {
  constexpr std::size_t page = 80;
  Table table{heads_of(costs), {}};
  std::string remarks;
  for (const FeatureCost& cost : costs) {
    if (cost.finished)
      table.rows.push_back(cells_of(cost, costs));
    else
      remarks += fmt::format("{} was not measured: {}\n", cost.name, cost.reason);
    const bool told = &cost != &costs.front() && cost.inside == costs.front().inside;
    if (!cost.inside.empty() && !told)
      remarks += fmt::format("{}: the kernel has {}\n", cost.name, fmt::join(cost.inside, ", "));
  }
  if (any_started(costs)) remarks += start_text(costs);
  return aligned(table) + fitted(remarks, page);
}

Table table_of(const std::vector<FeatureCost>& costs) {
  Table table{{"feature", "what", "cpu_s", "start_cpu_s", "start_bytes", "bytes",
               "ns_per_node_step", "instructions_per_node_step", "start_instructions"},
              {}};
  const auto number = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.6g}", *value) : "";
  };
  for (const FeatureCost& cost : costs)
    if (cost.finished)
      table.rows.push_back({cost.name, cost.what, fmt::format("{:.6g}", cost.cpu),
                            fmt::format("{:.6g}", cost.start_cpu),
                            fmt::format("{}", cost.start_bytes), fmt::format("{}", cost.bytes),
                            fmt::format("{:.6g}", cost.ns_per_node_step), number(cost.instructions),
                            number(cost.start_instructions)});
  return table;
}

Json to_json(const std::vector<FeatureCost>& costs) {
  Json json{{"schema", 1}, {"kind", "features"}, {"features", Json::array()}};
  const auto number = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  for (const FeatureCost& cost : costs) {
    Json one{{"name", cost.name},
             {"what", cost.what},
             {"cpu_s", cost.cpu},
             {"start_cpu_s", cost.start_cpu},
             {"start_bytes", cost.start_bytes},
             {"bytes", cost.bytes},
             {"ns_per_node_step", cost.ns_per_node_step},
             {"instructions_per_node_step", number(cost.instructions)},
             {"start_instructions", number(cost.start_instructions)},
             {"kernel_features", cost.inside}};
    if (!cost.finished) one["failed"] = cost.reason;
    json["features"].push_back(std::move(one));
  }
  return json;
}

}  // namespace hackle
