// SPDX-License-Identifier: MIT
#include "store/snapshot_head.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hackle {
namespace {

using HeadJson = nlohmann::json;

HeadJson json_of(const Vec2& vector) {
  return {vector.x(), vector.y()};
}
HeadJson json_of(const Clock& clock) {
  return {clock.moment, clock.since};
}
HeadJson json_of(double number) {
  return number;
}
HeadJson json_of(std::int64_t number) {
  return number;
}
HeadJson json_of(const std::vector<Disc>& discs) {
  HeadJson list = HeadJson::array();
  for (const Disc& disc : discs) list.push_back({json_of(disc.centre), json_of(disc.velocity)});
  return list;
}
HeadJson json_of(const std::vector<LoadedNode>& nodes) {
  HeadJson list = HeadJson::array();
  for (const LoadedNode& node : nodes)
    list.push_back({node.i, node.j, json_of(node.acceleration), node.inertia});
  return list;
}

HeadJson json_of(const std::vector<BrokenBond>& bonds) {
  HeadJson list = HeadJson::array();
  for (const BrokenBond& bond : bonds) list.push_back({bond.at, bond.word, bond.bit});
  return list;
}
HeadJson json_of(const std::optional<SlowCourse>& course) {
  if (!course) return nullptr;
  const auto& [begin, end, increments, result] = *course;
  return {begin, end, increments, result.passes, result.iterations, result.broken};
}

double number(const HeadJson& json) {
  const double value = json.get<double>();
  if (!std::isfinite(value)) throw std::invalid_argument("not finite");
  return value;
}
void set(double& to, const HeadJson& json) {
  to = number(json);
}
void set(std::int64_t& to, const HeadJson& json) {
  to = json.get<std::int64_t>();
  if (to < 0 || static_cast<double>(to) > max_steps) throw std::invalid_argument("a step");
}
void set(Vec2& to, const HeadJson& json) {
  to = {number(json.at(0)), number(json.at(1))};
}
void set(Clock& to, const HeadJson& json) {
  to.moment = number(json.at(0));
  set(to.since, json.at(1));
}
void set(std::vector<Disc>& to, const HeadJson& json) {
  for (const HeadJson& disc : json) {
    to.emplace_back();
    set(to.back().centre, disc.at(0));
    set(to.back().velocity, disc.at(1));
  }
}
void set(std::vector<LoadedNode>& to, const HeadJson& json) {
  for (const HeadJson& entry : json) {
    LoadedNode& node = to.emplace_back();
    node.i = entry.at(0).get<int>();
    node.j = entry.at(1).get<int>();
    set(node.acceleration, entry.at(2));
    node.inertia = number(entry.at(3));
  }
}

void set(std::vector<BrokenBond>& to, const HeadJson& json) {
  for (const HeadJson& bond : json) to.push_back({bond.at(0), bond.at(1), bond.at(2)});
}
void set(std::optional<SlowCourse>& to, const HeadJson& json) {
  if (json.is_null()) return;
  SlowCourse& course = to.emplace();
  set(course.begin, json.at(0));
  set(course.end, json.at(1));
  course.increments = json.at(2).get<int>();
  course.result.passes = json.at(3).get<std::vector<int>>();
  set(course.result.iterations, json.at(4));
  set(course.result.broken, json.at(5));
}

}  // namespace

HeadJson head_of(const Snapshot& snapshot) {
  HeadJson state;
  for_each_member(snapshot.state, [&](const char* name, const auto& member, bool) {
    if constexpr (is_in_head<std::remove_cvref_t<decltype(member)>>) state[name] = json_of(member);
  });
  return {{"precision", std::string(name_of(snapshot.state.precision()))},
          {"state", state},
          {"aim", {snapshot.aim.end_time, snapshot.aim.last_step}},
          {"borne", json_of(snapshot.borne)},
          {"widened_at", snapshot.widened_at ? HeadJson(*snapshot.widened_at) : HeadJson()},
          {"max_energy", snapshot.max_energy},
          {"solve_seconds", snapshot.solve_seconds},
          {"broken_bonds", json_of(snapshot.broken_bonds)},
          {"course", json_of(snapshot.course)}};
}

namespace {

bool is_node(std::ptrdiff_t at, const Grid& grid) {
  const NodeLayout layout = grid.layout();
  if (at < 0 || at >= static_cast<std::ptrdiff_t>(layout.size())) return false;
  const auto j = static_cast<int>(at / layout.stride());
  return grid.contains(static_cast<int>(at - layout.at(0, j)), j);
}

bool is_bond(const BrokenBond& bond, const Grid& grid, const BondBits& bits) {
  return is_node(bond.at, grid) && bond.word >= 0 && std::has_single_bit(bond.bit) &&
         static_cast<std::size_t>(bond.word) * bits.plane() < bits.words().size();
}

}  // namespace

bool names_only_its_own(const Snapshot& snapshot, const Grid& grid) {
  return std::ranges::all_of(
             snapshot.borne,
             [&](const LoadedNode& node) { return grid.contains(node.i, node.j); }) &&
         std::ranges::all_of(snapshot.broken_bonds, [&](const BrokenBond& bond) {
           return is_bond(bond, grid, snapshot.state.bonds);
         });
}

void read_head(const HeadJson& head, Snapshot& snapshot) {
  if (head.at("precision") == name_of(Precision::f32))
    snapshot.state.motion = Motion<float>();
  else
    snapshot.state.motion = Motion<double>();
  for_each_member(snapshot.state, [&](const char* name, auto& member, bool) {
    if constexpr (is_in_head<std::remove_cvref_t<decltype(member)>>)
      set(member, head.at("state").at(name));
  });
  set(snapshot.aim.end_time, head.at("aim").at(0));
  set(snapshot.aim.last_step, head.at("aim").at(1));
  set(snapshot.borne, head.at("borne"));
  if (!head.at("widened_at").is_null()) snapshot.widened_at = number(head.at("widened_at"));
  snapshot.max_energy = number(head.at("max_energy"));
  snapshot.solve_seconds = number(head.at("solve_seconds"));
  set(snapshot.broken_bonds, head.at("broken_bonds"));
  set(snapshot.course, head.at("course"));
}

}  // namespace hackle
