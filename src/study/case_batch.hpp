// SPDX-License-Identifier: MIT
// The cases that a study wants at one time: some are kept, some run here, some in other processes
// that share the study's folder.
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/child_process.hpp"
#include "base/progress.hpp"
#include "study/case_claim.hpp"
#include "study/case_store.hpp"

namespace hackle {

struct BatchOptions {
  std::string what;         // for progress
  double time_limit = 0.0;  // s of wall time of a case
  int threads = 1;          // of a case
  int at_once = 1;          // cases that run here
  Talk talk = Talk::plain;
  bool notes = false;      // says which cases are taken over
  bool fresh = false;      // outcomes of earlier sessions do not count
  bool must_lock = false;  // others share the work for certain
};

class CaseBatch {
 public:
  CaseBatch(const CaseStore& store, const StudySession& session, std::span<const Case> cases,
            BatchOptions options);
  // Returns the outcomes in the order of the cases, when all are there. Throws Error (interrupted,
  // files); programs that still run are then killed, and their cases left to others.
  std::vector<Outcome> run();

 private:
  using Clock = std::chrono::steady_clock;
  struct Running {
    std::size_t number;
    Provenance made;
    CaseClaim claim;
    ChildProcess child;  // killed before the claim is given up
  };

  bool recall(std::size_t number);
  bool begin(std::size_t number);
  void begin_some();
  void look_for_outcomes();
  void look_around();
  void end_some();
  void end(Running& one, const ChildResult& result);
  void note(const Provenance& left_by, const Case& one);
  std::string waits_for() const;
  void show();
  void pause() const;
  bool is_full() const { return running_.size() >= static_cast<std::size_t>(options_.at_once); }
  std::vector<std::string> words_of(const Case& one) const;

  const CaseStore* store_;
  const StudySession* session_;
  std::span<const Case> cases_;
  BatchOptions options_;
  std::vector<Outcome> outcomes_;
  std::vector<std::size_t>
      waiting_;  // in order: those that run here have left, not those elsewhere
  std::vector<Running> running_;
  std::optional<std::size_t> elsewhere_;  // a case that another process has
  std::size_t all_ = 0, done_ = 0;
  std::size_t cursor_ = 0;  // the next to look for
  Clock::time_point next_look_;
  std::chrono::milliseconds interval_;  // between looks
  std::optional<Progress> progress_;
};

}  // namespace hackle
