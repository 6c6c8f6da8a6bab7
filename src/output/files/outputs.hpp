// SPDX-License-Identifier: MIT
// The movies and records of a run together.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "output/files/output.hpp"
#include "output/files/output_names.hpp"
#include "solver/simulation.hpp"

namespace hackle {

class Outputs {
 public:
  // Together they may take `max_bytes`.
  explicit Outputs(double max_bytes) : limit_(max_bytes) {}
  void limit(double bytes) { limit_ = bytes; }
  double limit() const { return limit_; }

  // Sets the registry in which every file is written only once; initially each object has its own.
  void share(std::shared_ptr<OutputNames> names) { names_ = std::move(names); }
  const std::shared_ptr<OutputNames>& names() const { return names_; }

  // Adds an output that will write `path`; `who` names the calling function. Throws Error (refused)
  // if the outputs are closed or somebody else writes it, Error (files) if it cannot be written.
  void add(const char* who, const std::filesystem::path& path, FileKind kind,
           std::unique_ptr<Output> output);

  // Outputs added from now on keep what another program needs to go on with them.
  void keep_continuable() { continuable_ = true; }
  // See Output, whose functions these call for each, in the order in which they were added.
  std::vector<OutputMark> marks() const;
  std::function<void()> settled();
  std::vector<std::filesystem::path> kept_files() const;
  // Throws Error (files) with every problem, also if the marks are those of other outputs. A folder
  // may have moved: only the names of files must agree.
  void continue_from(const std::vector<OutputMark>& marks);

  // Makes sure that all of them can begin, before any does. Throws Error (files).
  void reserve();

  bool empty() const { return all_.empty(); }
  bool closed() const { return closed_; }

  // Throws Error (refused) if `duration` s more, with at most `max_looks` calls of each, would
  // exceed the limit.
  void check_room(const Simulation& simulation, double duration, std::int64_t max_looks) const;

  std::vector<Observer*> observers() const;

  // Completes all files. Throws Error with every problem.
  void close();

  // Adds the files and the wall time so far.
  void add_to(Summary& summary) const;

 private:
  std::vector<std::unique_ptr<Output>> all_;
  std::vector<std::filesystem::path> paths_;
  std::shared_ptr<OutputNames> names_ = std::make_shared<OutputNames>();
  double limit_;
  bool continuable_ = false;
  bool closed_ = false;
};

}  // namespace hackle
