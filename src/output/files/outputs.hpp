// SPDX-License-Identifier: MIT
// The movies and records of a run, together.
#pragma once

#include <memory>
#include <vector>

#include "output/files/output.hpp"
#include "output/files/output_names.hpp"
#include "solver/simulation.hpp"

namespace hackle {

class Outputs {
 public:
  // They may take so many bytes in all.
  explicit Outputs(double max_bytes) : limit_(max_bytes) {}
  void limit(double bytes) { limit_ = bytes; }
  double limit() const { return limit_; }

  // The files of all that share them are written once; a registry of its own at first.
  void share(std::shared_ptr<OutputNames> names) { names_ = std::move(names); }
  const std::shared_ptr<OutputNames>& names() const { return names_; }

  // Takes one on that is going to write `path`; `who` names the call. Throws Error (refused) when
  // they are closed or somebody else writes it, Error (files) when it cannot be written.
  void add(const char* who, const std::filesystem::path& path, FileKind kind,
           std::unique_ptr<Output> output);

  // Makes sure that all of them can begin, before one does. Throws Error (files).
  void reserve();

  bool empty() const { return all_.empty(); }
  bool closed() const { return closed_; }

  // Throws Error (refused) when `duration` s more, with at most so many looks of each, would take
  // more than the limit.
  void check_room(const Simulation& simulation, double duration, std::int64_t max_looks) const;

  std::vector<Observer*> observers() const;

  // Completes all files. Throws Error with every problem there was.
  void close();

  // Adds the files and the wall time so far.
  void add_to(Summary& summary) const;

 private:
  std::vector<std::unique_ptr<Output>> all_;
  std::vector<std::filesystem::path> paths_;
  std::shared_ptr<OutputNames> names_ = std::make_shared<OutputNames>();
  double limit_;
  bool closed_ = false;
};

}  // namespace hackle
