// SPDX-License-Identifier: MIT
#include "output/files/outputs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

// What went wrong with several outputs, each of which is tried.
class Failures {
 public:
  template <class Work>
  void attempt(const Work& work) {
    try {
      work();
    } catch (const Error& error) {
      kind_ = error.kind();
      problems_.insert(problems_.end(), error.problems().begin(), error.problems().end());
    }
  }
  void throw_if_any() {
    if (!problems_.empty()) throw Error(kind_, std::move(problems_));
  }

 private:
  ErrorKind kind_ = ErrorKind::files;
  std::vector<Problem> problems_;
};

}  // namespace

void Outputs::add(const char* who, const std::filesystem::path& path, FileKind kind,
                  std::unique_ptr<Output> output) {
  if (closed_)
    throw Error(ErrorKind::refused, fmt::format("{}: the simulation is closed", who),
                "ask for outputs before s:close()");
  check_writable(path);
  names_->claim(who, path, kind);
  if (continuable_) output->keep_continuable();
  paths_.push_back(path);
  all_.push_back(std::move(output));
}

void Outputs::reserve() {
  for (const auto& output : all_) output->reserve();
}

std::vector<OutputMark> Outputs::marks() const {
  std::vector<OutputMark> list;
  for (const auto& output : all_) list.push_back(output->mark());
  return list;
}

std::function<void()> Outputs::settled() {
  std::vector<std::function<void()>> list;
  for (const auto& output : all_) list.push_back(output->settled());
  return [list = std::move(list)] {
    for (const auto& settle : list) settle();
  };
}

std::vector<std::filesystem::path> Outputs::kept_files() const {
  std::vector<std::filesystem::path> list;
  for (const auto& output : all_)
    for (std::filesystem::path& file : output->kept_files()) list.push_back(std::move(file));
  return list;
}

void Outputs::continue_from(const std::vector<OutputMark>& marks) {
  const auto same = [](const auto& output, const OutputMark& mark) {
    return output->mark().file.filename() == mark.file.filename();
  };
  if (!std::ranges::equal(all_, marks, same))
    throw Error(ErrorKind::files, "its movies and records are not those of the run to go on with",
                "begin anew with --fresh");
  Failures failures;
  for (std::size_t k = 0; k < marks.size(); ++k)
    failures.attempt([&] { all_[k]->continue_from(marks[k]); });
  failures.throw_if_any();
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
  Failures failures;
  for (const auto& output : all_) failures.attempt([&] { output->close(); });
  for (const std::filesystem::path& path : paths_) names_->complete(path);
  failures.throw_if_any();
}

void Outputs::add_to(Summary& summary) const {
  for (const auto& output : all_) {
    output->add_seconds(summary.wall);
    for (const std::filesystem::path& file : output->files()) summary.files.push_back(file);
  }
}

}  // namespace hackle
