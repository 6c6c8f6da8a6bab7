// SPDX-License-Identifier: MIT
#include "output/files/outputs.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/units.hpp"

namespace hackle {

void Outputs::add(const char* who, const std::filesystem::path& path, FileKind kind,
                  std::unique_ptr<Output> output) {
  if (closed_)
    throw Error(ErrorKind::refused, fmt::format("{}: the simulation is closed", who),
                "ask for outputs before s:close()");
  check_writable(path);
  names_->claim(who, path, kind);
  paths_.push_back(path);
  all_.push_back(std::move(output));
}

void Outputs::reserve() {
  for (const auto& output : all_) output->reserve();
}

void Outputs::check_room(const Simulation& simulation, double duration,
                         std::int64_t max_looks) const {
  const double until = simulation.end_time() + duration + 0.5 * simulation.dt();
  double bytes = 0.0;
  std::string list;
  for (const auto& output : all_) {
    const Expected one = output->expected(until, max_looks);
    bytes += one.bytes;
    list += fmt::format("{}'{}' {} in {} pieces", list.empty() ? "" : ", ", one.file.string(),
                        quantity(one.bytes, "B"), grouped(one.pieces));
  }
  if (bytes <= limit_) return;
  throw Error(ErrorKind::refused,
              fmt::format("run: its files would take about {}, the limit is {}: {}",
                          quantity(bytes, "B"), quantity(limit_, "B"), list),
              fmt::format("take a longer `every`, or allow it with --output-limit {:.0f} (in GB)",
                          std::ceil(1.1e-9 * bytes)));
}

std::vector<Observer*> Outputs::observers() const {
  std::vector<Observer*> list;
  for (const auto& output : all_) list.push_back(output.get());
  return list;
}

void Outputs::close() {
  closed_ = true;
  std::vector<Problem> problems;
  ErrorKind kind = ErrorKind::files;
  for (const auto& output : all_) {
    try {
      output->close();
    } catch (const Error& error) {  // the other files are still completed
      kind = error.kind();
      problems.insert(problems.end(), error.problems().begin(), error.problems().end());
    }
  }
  for (const std::filesystem::path& path : paths_) names_->complete(path);
  if (!problems.empty()) throw Error(kind, std::move(problems));
}

void Outputs::add_to(Summary& summary) const {
  for (const auto& output : all_) {
    output->add_seconds(summary.wall);
    for (const std::filesystem::path& file : output->files()) summary.files.push_back(file);
  }
}

}  // namespace hackle
