// SPDX-License-Identifier: MIT
#include "console/session.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/files.hpp"

namespace hackle {

Session::Session(ConsoleSettings with) : settings(std::move(with)) {
}

Session::~Session() = default;

std::filesystem::path Session::output_path(const std::filesystem::path& name) const {
  return settings.output_folder / name;
}

std::shared_ptr<Run> Session::simulate(Plate plate, Numerics numerics) {
  return adopt(
      std::make_shared<Run>(std::move(plate), numerics, settings.execution, settings.talk, origin));
}

std::shared_ptr<Run> Session::adopt(std::shared_ptr<Run> run) {
  entries_.push_back({run, std::nullopt});
  return run;
}

void Session::retire(const Run* run) noexcept {
  const auto entry = std::ranges::find(entries_, run, [](const Entry& e) { return e.run.get(); });
  if (entry == entries_.end()) return;
  close(*entry->run);
  try {
    entry->summary = entry->run->summary();
  } catch (const std::exception& error) {
    closing_problems_.push_back({error.what(), {}});
  }
  entry->run.reset();
}

void Session::close(Run& run) noexcept {
  try {
    run.close();
  } catch (const Error& error) {
    closing_kind_ = error.kind();
    for (const Problem& problem : error.problems()) closing_problems_.push_back(problem);
  } catch (const std::exception& error) {
    closing_kind_ = ErrorKind::run_failed;
    closing_problems_.push_back({error.what(), {}});
  }
}

void Session::close_all() {
  for (const Entry& entry : entries_)
    if (entry.run) close(*entry.run);
  const std::vector<Problem> problems = std::exchange(closing_problems_, {});
  if (!problems.empty()) throw Error(closing_kind_, problems);
}

std::vector<Summary> Session::summaries() const {
  std::vector<Summary> list;
  for (const Entry& entry : entries_)
    if (entry.run || entry.summary)
      list.push_back(entry.run ? entry.run->summary() : *entry.summary);
  return list;
}

const Materials& Session::materials() {
  if (!materials_) materials_.emplace(data_file("assets/materials.lua"));
  return *materials_;
}

void Session::check_overrides_used() const {
  Problems problems;
  for (const auto& [key, value] : settings.overrides)
    if (!declared_options.contains(key))
      problems.add(fmt::format("--set {}={}: the script has no options to set", key, value),
                   fmt::format("declare them in it: local o = options {{ {} = ... }}", key));
  problems.throw_if_any();
}

}  // namespace hackle
