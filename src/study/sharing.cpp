// SPDX-License-Identifier: MIT
#include "study/sharing.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"

namespace hackle {
namespace {

using MachineAndProcess = std::pair<std::string, int>;

MachineAndProcess who_ran(const Provenance& made) {
  return {made.machine, made.process};
}

// "2 runs"; of at least one.
std::string amount(std::size_t count, const char* noun) {
  return counted(count, noun).substr(2);
}

// "9, 8, 7", or "2 to 9" of many; the largest comes first.
std::string list_of(const std::vector<int>& counts) {
  constexpr std::size_t many = 9;
  return counts.size() < many ? fmt::format("{}", fmt::join(counts, ", "))
                              : fmt::format("{} to {}", counts.back(), counts.front());
}

}  // namespace

// What was kept before processes were noted has none.
void Sharing::add(const std::string& key, const Outcome& outcome) {
  if (outcome.made.process != 0) runs_.insert_or_assign(key, Run{outcome.made, outcome.wall});
}

void Sharing::add(const Sharing& other) {
  for (const auto& [key, run] : other.runs_) runs_.insert_or_assign(key, run);
}

int Sharing::at_once() const {
  std::vector<std::tuple<double, int, MachineAndProcess>> events;  // time, +1 or -1
  for (const auto& [key, run] : runs_) {
    events.emplace_back(run.made.began, 1, who_ran(run.made));
    events.emplace_back(run.made.began + run.wall, -1, who_ran(run.made));
  }
  std::ranges::sort(events);
  std::map<MachineAndProcess, int> active;
  std::size_t most = 1;
  for (const auto& [time, change, worker] : events) {
    if ((active[worker] += change) == 0) active.erase(worker);
    most = std::max(most, active.size());
  }
  return static_cast<int>(most);
}

int Sharing::made_in(const StudySession& session) const {
  return static_cast<int>(std::ranges::count_if(
      runs_, [&](const auto& one) { return session.includes(one.second.made); }));
}

std::vector<int> Sharing::runs_of_processes() const {
  std::map<MachineAndProcess, int> counts;
  for (const auto& [key, run] : runs_) ++counts[who_ran(run.made)];
  std::vector<int> all;
  all.reserve(counts.size());
  for (const auto& [worker, count] : counts) all.push_back(count);
  std::ranges::sort(all, std::greater{});
  return all;
}

std::size_t Sharing::machines() const {
  std::set<std::string> names;
  for (const auto& [key, run] : runs_) names.insert(run.made.machine);
  return names.size();
}

std::size_t Sharing::taken_over() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(runs_, [](const auto& one) { return one.second.made.taken_over; }));
}

std::string Sharing::text() const {
  const int most = at_once();
  if (most < 2) return "";
  const std::vector<int> counts = runs_of_processes();
  std::string text =
      fmt::format("{} runs by {} processes on {} ({}), up to {} at once\n", runs_.size(),
                  counts.size(), amount(machines(), "machine"), list_of(counts), most);
  if (const std::size_t count = taken_over(); count > 0)
    text += fmt::format("{} taken over from processes that ended\n", amount(count, "run"));
  return text + "Processes on one machine slow each other down: times of runs include that.\n";
}

nlohmann::ordered_json Sharing::json() const {
  const int most = at_once();
  if (most < 2) return nullptr;
  const std::vector<int> counts = runs_of_processes();
  return {{"processes", counts.size()},
          {"machines", machines()},
          {"at_once", most},
          {"runs", counts},
          {"taken_over", taken_over()}};
}

}  // namespace hackle
