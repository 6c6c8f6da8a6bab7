// SPDX-License-Identifier: MIT
#include "app/command_diff.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/exit_code.hpp"
#include "app/voice.hpp"
#include "base/interrupt.hpp"
#include "base/streams.hpp"
#include "base/units.hpp"
#include "store/run_difference.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::vector<Difference>& inputs) {
  Json list = Json::array();
  for (const auto& [path, one, other] : inputs)
    list.push_back({{"path", path}, {"one", one}, {"other", other}});
  return list;
}

Json json_of(const FieldCourse& course, const Grid& grid) {
  const auto& [name, unit, max, i, j, l2] = course.largest;
  Json json{{"name", name},        {"unit", unit}, {"first_time_s", course.first},
            {"time_s", course.at}, {"max", max},   {"l2", course.l2}};
  if (i < 0) return json;
  const Vec2 place = grid.position(i, j);
  json["node"] = {i, j};
  json["place_m"] = {place.x(), place.y()};
  return json;
}

void print_json(const RunDifference& found, const DiffRequest& request, const Grid& grid) {
  Json json{{"schema", 1},
            {"one", request.one.string()},
            {"other", request.other.string()},
            {"equal", found.is_none()},
            {"inputs", json_of(found.inputs)},
            {"same_grid", found.same_grid},
            {"common_times", found.common.size()},
            {"only_in_one", found.only_in_one},
            {"only_in_other", found.only_in_other}};
  const std::optional<double> first = found.first_time();
  json["first_time_s"] = first ? Json(*first) : Json();
  json["fields"] = Json::array();
  for (const FieldCourse& course : found.fields) json["fields"].push_back(json_of(course, grid));
  print_out("{}\n", json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string text_of_times(const RunDifference& found) {
  if (!found.same_grid) return "the lattices differ: fields are not compared";
  std::string text =
      found.common.empty()
          ? "no common time"
          : fmt::format("{} in common, {} to {}",
                        grouped(static_cast<long long>(found.common.size())),
                        quantity(found.common.front(), "s"), quantity(found.common.back(), "s"));
  if (found.only_in_one + found.only_in_other > 0)
    text += fmt::format("; {} only in the first file, {} only in the second", found.only_in_one,
                        found.only_in_other);
  return text;
}

void print_field(const FieldCourse& course, const Grid& grid) {
  const auto& [name, unit, max, i, j, l2] = course.largest;
  const Vec2 place = i < 0 ? Vec2(0.0, 0.0) : grid.position(i, j);
  const std::string where = i < 0 ? ""
                                  : fmt::format("node ({}, {}) at ({}, {})", i, j,
                                                quantity(place.x(), "m"), quantity(place.y(), "m"));
  print_out("  {:<13} {:>10} {:>12} {:>10} {:>12}  {}\n", name, quantity(course.first, "s"),
            quantity(max, unit), quantity(course.at, "s"), quantity(course.l2, unit), where);
}

void print(const RunDifference& found, const Grid& grid) {
  if (found.is_none()) {
    print_out("equal: the inputs, and the states at {} time{}\n", found.common.size(),
              found.common.size() == 1 ? "" : "s");
    return;
  }
  print_out("inputs   {}\n",
            found.inputs.empty() ? "equal" : fmt::format("{} differ", found.inputs.size()));
  for (const auto& [path, one, other] : found.inputs)
    print_out("  {}: {} against {}\n", path, printable(one), printable(other));
  print_out("times    {}\n", text_of_times(found));
  if (!found.same_grid || found.common.empty()) return;
  if (found.fields.empty()) return print_out("fields   equal\n");
  print_out("{:<15} {:>10} {:>12} {:>10} {:>12}\n", "fields", "first at", "largest", "at", "L2");
  for (const FieldCourse& course : found.fields) print_field(course, grid);
}

RunDifference compared(StoredRun& one, StoredRun& other, const DiffRequest& request) {
  Progress progress(talk(request.quiet));
  return difference(one, other, [&](double share) {
    if (progress.due(share)) progress.show(share, "comparing");
  });
}

}  // namespace

int command_diff(const DiffRequest& request) {
  const InterruptHandler handler;
  return exit_code_of([&] {
    StoredRun one(request.one), other(request.other);
    const RunDifference found = compared(one, other, request);
    const Grid& grid = one.view().lattice().grid;
    if (request.json)
      print_json(found, request, grid);
    else if (!request.quiet)
      print(found, grid);
    return found.is_none() ? 0 : 1;
  });
}

}  // namespace hackle
