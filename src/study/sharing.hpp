// SPDX-License-Identifier: MIT
// How several processes have shared the runs of a study.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "study/case.hpp"

namespace hackle {

class Sharing {
 public:
  // Counts the run of a case; `key` tells cases apart, and none is counted twice.
  void add(const std::string& key, const Outcome& outcome);
  void add(const Sharing& other);

  // Returns how many processes ran cases at the same time, at most: 1 for a study that one process
  // after the other has worked at.
  int at_once() const;
  // Returns the number of cases that were begun within the session.
  int made_in(const StudySession& session) const;

  // "24 runs by 3 processes on 1 machine (9, 8, 7), up to 3 at once" and more lines; "" if none was
  // shared.
  std::string text() const;
  // {"processes":3,"machines":1,"at_once":3,"runs":[9,8,7],"taken_over":1}; null if none was
  // shared.
  nlohmann::ordered_json json() const;

 private:
  struct Run {
    Provenance made;
    double wall;  // s
  };
  std::vector<int> runs_of_processes() const;  // the largest first
  std::size_t machines() const;
  std::size_t taken_over() const;

  std::map<std::string, Run> runs_;
};

}  // namespace hackle
