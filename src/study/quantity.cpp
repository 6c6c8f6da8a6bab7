// SPDX-License-Identifier: MIT
#include "study/quantity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <mutex>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/text.hpp"
#include "study/path_distance.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;
using enum ComparedAs;

constexpr std::string_view of_script = "expect.";

constexpr auto rows = std::to_array<QuantityRow>({
    {"displacement", field, "", "Displacements before the first bond breaks."},
    {"first_bond.time", number, "s", "When the first bond breaks."},
    {"first_bond.place", place, "m", "Where it breaks."},
    {"tip.path", paths, "m", "All paths that cracks have grown along."},
    {"tip.speed", number, "m/s", "The largest speed of a tip."},
    {"arrival.time", number, "s", "When a tip first comes to an edge or a hole."},
    {"fork.time", number, "s", "When a crack first forks."},
    {"fork.place", place, "m", "Where it forks."},
    {"fork.angle", number, "rad", "The angle between the branches there."},
    {"branches", count, "", "The number of tips of all that has grown."},
    {"crack.length", number, "m", "The length of all that has grown."},
    {"fragments", count, "", "The number of fragments, dust not counted."},
    {"fragments.largest", number, "m2", "The area of the largest fragment."},
    {"fragments.median", number, "m2", "Half of the area is in fragments up to this one."},
    {"energy.broken", number, "J/m", "The energy that broken bonds took."},
    {"stiffness", number, "Pa", "Resistance to a uniform strain, with rims and cracks."},
    {"wave.speed", number, "m/s", "The speed of waves as long as a fifth of the shorter side."},
    {"residual", number, "", "What the energy ledger lacks, as a share of its entries.", true},
});

// Rows outlive the words that name them.
std::string_view kept(std::string_view name) {
  static std::mutex mutex;
  static std::set<std::string, std::less<>> names;
  const std::lock_guard lock(mutex);
  const auto known = names.find(name);
  return known != names.end() ? *known : *names.emplace(name).first;
}

const Json* found(const Json& object, std::string_view key) {
  const auto at = object.find(key);
  return at == object.end() || at->is_null() ? nullptr : &*at;
}

std::optional<double> number_in(const Json* object, std::string_view key) {
  const Json* value = object ? found(*object, key) : nullptr;
  return value && value->is_number() ? std::optional(value->get<double>()) : std::nullopt;
}

std::optional<Vec2> place_in(const Json* object) {
  const Json* value = object ? found(*object, "place_m") : nullptr;
  if (!value) return std::nullopt;
  return Vec2((*value)[0].get<double>(), (*value)[1].get<double>());
}

// The first event of a kind with a time.
const Json* event_of(const Json& told, std::string_view kind) {
  const Json* events = found(told, "events");
  if (!events) return nullptr;
  for (const Json& event : *events)
    if (event["kind"] == kind && found(event, "time_s")) return &event;
  return nullptr;
}

template <class Visit>
void for_each_grown(const Json& told, const Visit& visit) {
  const Json* graph = found(told, "graph");
  if (!graph) return;
  for (const Json& crack : (*graph)["cracks"])
    if (!crack["initial"].get<bool>()) visit(crack);
}

std::vector<Line> paths_of(const Json& told) {
  std::vector<Line> all;
  for_each_grown(told, [&](const Json& crack) {
    Line& line = all.emplace_back();
    for (const Json& point : crack["points_m"])
      line.emplace_back(point[0].get<double>(), point[1].get<double>());
    if (line.empty()) all.pop_back();
  });
  return all;
}

double length_of(const Json& told) {
  double length = 0.0;
  for_each_grown(told, [&](const Json& crack) { length += crack["length_m"].get<double>(); });
  return length;
}

std::optional<double> speed_of(const Json& told) {
  std::optional<double> fastest;
  for_each_grown(told, [&](const Json& crack) {
    if (const auto speed = number_in(&crack, "max_speed_m_per_s"))
      fastest = std::max(fastest.value_or(0.0), *speed);
  });
  return fastest;
}

double branches_of(const Json& told) {
  const Json* graph = found(told, "graph");
  if (!graph) return 0.0;
  return static_cast<double>(std::ranges::count_if((*graph)["tips"], [](const Json& tip) {
    return tip["state"] != "initial" && tip["state"] != "joined";
  }));
}

// The areas of fragments, m2, from the largest on.
std::vector<double> areas_of(const Json& told) {
  const Json* fragments = found(told, "fragments");
  return fragments ? (*fragments)["areas_m2"].get<std::vector<double>>() : std::vector<double>();
}

std::optional<double> median_of(const std::vector<double>& areas) {
  const double half = 0.5 * std::accumulate(areas.begin(), areas.end(), 0.0);
  double counted = 0.0;
  for (auto area = areas.rbegin(); area != areas.rend(); ++area)
    if ((counted += *area) >= half) return *area;
  return std::nullopt;
}

std::optional<double> fragments_of(const Json& told, std::string_view name) {
  if (!found(told, "fragments")) return std::nullopt;
  const std::vector<double> areas = areas_of(told);
  if (name == "fragments.median") return median_of(areas);
  if (name == "fragments.largest")
    return areas.empty() ? std::nullopt : std::optional(areas.front());
  return static_cast<double>(areas.size());
}

std::vector<std::optional<Vec2>> field_of(const Json& told) {
  std::vector<std::optional<Vec2>> all;
  if (const Json* sample = found(told, "sample"))
    for (const Json& value : (*sample)["displacements_m"])
      all.push_back(value.is_null() ? std::optional<Vec2>()
                                    : Vec2(value[0].get<double>(), value[1].get<double>()));
  return all;
}

std::optional<double> expected_of(const Json& told, std::string_view name) {
  if (const Json* all = found(told, "expectations"))
    for (const Json& one : *all)
      if (one["quantity"] == name) return number_in(&one, "got");
  return std::nullopt;
}

std::optional<double> number_of(const Json& told, std::string_view name) {
  if (name == "stiffness") return number_in(found(told, "elastic"), "stiffness_Pa");
  if (name == "wave.speed") return number_in(found(told, "elastic"), "wave_speed_m_per_s");
  if (name == "first_bond.time") return number_in(found(told, "first_break"), "time_s");
  if (name == "fork.time") return number_in(event_of(told, "branch"), "time_s");
  if (name == "fork.angle") return number_in(event_of(told, "branch"), "angle_rad");
  if (name == "arrival.time") return number_in(event_of(told, "arrival"), "time_s");
  if (name == "tip.speed") return speed_of(told);
  if (name == "branches") return branches_of(told);
  if (name == "crack.length") return length_of(told);
  if (name.starts_with("fragments")) return fragments_of(told, name);
  if (name == "energy.broken") return number_in(found(told, "energy_J_per_m"), "broken");
  if (name == "residual") return number_in(&told, "residual_share");
  return expected_of(told, name.substr(std::min(of_script.size(), name.size())));
}

// Relative to the second one, over the places that both have.
std::optional<double> field_distance(const std::vector<std::optional<Vec2>>& one,
                                     const std::vector<std::optional<Vec2>>& other) {
  double difference = 0.0, size = 0.0;
  for (std::size_t k = 0; k < std::min(one.size(), other.size()); ++k)
    if (one[k] && other[k]) {
      difference += (*one[k] - *other[k]).squaredNorm();
      size += other[k]->squaredNorm();
    }
  if (size > 0.0) return std::sqrt(difference / size);
  return difference > 0.0 ? std::nullopt : std::optional(0.0);
}

}  // namespace

std::span<const QuantityRow> quantity_rows() {
  return rows;
}

std::optional<QuantityRow> quantity_named(std::string_view name) {
  const auto row = std::ranges::find(rows, name, &QuantityRow::name);
  if (row != rows.end()) return *row;
  if (name.starts_with(of_script) && name.size() > of_script.size())
    return QuantityRow{kept(name), number, "", "What the script expects under this name."};
  return std::nullopt;
}

std::vector<QuantityRow> quantities_named(const std::vector<std::string>& names) {
  std::vector<std::string_view> known;
  known.reserve(rows.size());
  for (const QuantityRow& row : rows) known.push_back(row.name);
  std::vector<QuantityRow> found;
  Problems problems;
  for (const std::string& name : names)
    if (const auto row = quantity_named(name))
      found.push_back(*row);
    else
      problems.add(fmt::format("there is no quantity '{}'{}", name, did_you_mean(name, known)),
                   "there are " + comma_list(known) + ", and expect.NAME of the script's own");
  problems.throw_if_any(ErrorKind::usage);
  return found;
}

QuantityValue value_of(const Outcome& outcome, const QuantityRow& row) {
  QuantityValue value;
  if (!outcome.finished()) return value;
  const Json& told = outcome.told;
  if (row.name == "displacement")
    value.field = field_of(told);
  else if (row.name == "tip.path")
    value.paths = paths_of(told);
  else if (row.name == "first_bond.place")
    value.place = place_in(found(told, "first_break"));
  else if (row.name == "fork.place")
    value.place = place_in(event_of(told, "branch"));
  else
    value.number = number_of(told, row.name);
  return value;
}

std::optional<double> error_of(const QuantityValue& value, const QuantityValue& reference,
                               const QuantityRow& row) {
  if (!row.is_error) return distance(value, reference, row);
  return value.number ? std::optional(std::abs(*value.number)) : std::nullopt;
}

std::optional<double> distance(const QuantityValue& one, const QuantityValue& other,
                               const QuantityRow& row) {
  if (!one.found() && !other.found()) return 0.0;
  if (!one.found() || !other.found()) return std::nullopt;
  if (row.kind == place) return (*one.place - *other.place).norm();
  if (row.kind == paths) return hausdorff_distance(one.paths, other.paths);
  if (row.kind == field) return field_distance(one.field, other.field);
  return std::abs(*one.number - *other.number);
}

}  // namespace hackle
