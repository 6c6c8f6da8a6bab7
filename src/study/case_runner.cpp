// SPDX-License-Identifier: MIT
#include "study/case_runner.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "study/case_batch.hpp"

namespace hackle {

CaseRunner::CaseRunner(StudyScript script, RunnerOptions options)
    : options_(std::move(options)),
      store_(std::move(script), options_.folder),
      session_(options_.launcher) {
}

std::vector<Outcome> CaseRunner::run(std::span<const Case> cases, const std::string& what,
                                     double time_limit) {
  return run(cases, what, time_limit, std::clamp(options_.threads_per_case, 1, options_.threads));
}

Outcome CaseRunner::run_alone(const Case& one, const std::string& what) {
  return run(std::span(&one, 1), what, std::numeric_limits<double>::infinity(), options_.threads)
      .front();
}

std::vector<Outcome> CaseRunner::run(std::span<const Case> cases, const std::string& what,
                                     double time_limit, int threads_per_case) {
  if (!cases.empty()) make_folder_of(store_.lock_of(cases.front()));
  CaseBatch batch(store_, session_, cases,
                  {.what = what,
                   .time_limit = time_limit,
                   .threads = threads_per_case,
                   .at_once = std::max(1, options_.threads / threads_per_case),
                   .talk = options_.talk,
                   .notes = options_.notes,
                   .fresh = options_.fresh,
                   .must_lock = !options_.launcher.is_alone()});
  std::vector<Outcome> outcomes = batch.run();
  for (const Outcome& outcome : outcomes) sharing_.add(store_.key_of(outcome.setting), outcome);
  return outcomes;
}

const Outcome& finished(const Outcome& outcome) {
  if (outcome.finished()) return outcome;
  throw Error(ErrorKind::run_failed,
              fmt::format("the run with {} did not finish: {}", name_of(outcome.setting.settings),
                          outcome.reason),
              "hackle run tells more");
}

}  // namespace hackle
