// SPDX-License-Identifier: MIT
// The movies and records of a run, together.
#pragma once

#include <memory>
#include <vector>

#include "output/output.hpp"
#include "solver/simulation.hpp"

namespace hackle {

class Outputs {
 public:
  // They may take so many bytes in all.
  explicit Outputs(double most_bytes) : limit_(most_bytes) {}
  void limit(double bytes) { limit_ = bytes; }
  double limit() const { return limit_; }

  // Takes one on that is going to write `path`; `who` names the call. Throws Error (refused) when
  // they are closed or another of them writes it, Error (files) when it cannot be written.
  void add(const char* who, const std::filesystem::path& path, std::unique_ptr<Output> output);

  bool empty() const { return all_.empty(); }
  bool closed() const { return closed_; }

  // Throws Error (refused) when `duration` s more, with at most so many looks of each, would take
  // more than the limit.
  void check_room(const Simulation& simulation, double duration, std::int64_t most_looks) const;

  std::vector<Observer*> observers() const;

  // Completes all files. Throws Error with every problem there was.
  void close();

  // Adds the files and the wall time so far.
  void add_to(Summary& summary) const;

 private:
  std::vector<std::unique_ptr<Output>> all_;
  std::vector<std::filesystem::path> paths_;
  double limit_;
  bool closed_ = false;
};

}  // namespace hackle
