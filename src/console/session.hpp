// SPDX-License-Identifier: MIT
// What the functions of a script share: how it was called, and the simulations it made.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "console/materials.hpp"
#include "output/run.hpp"

namespace hackle {

struct ConsoleSettings {
  std::filesystem::path output_folder;           // "": out/<name of the script>
  std::map<std::string, std::string> overrides;  // --set key=value
  Execution execution;
  Talk talk = Talk::plain;
  bool print_to_stderr = false;  // what the script prints: stdout is for something else
};

class Session {
 public:
  explicit Session(ConsoleSettings settings);
  ~Session();

  // Where a file that the script names goes: below the output folder unless the name is absolute.
  std::filesystem::path output_path(const std::filesystem::path& name) const;

  // Throws what Run throws.
  std::shared_ptr<Run> simulate(Plate plate, Numerics numerics);
  // Takes on a run made from another.
  std::shared_ptr<Run> adopt(std::shared_ptr<Run> run);
  // Closes a run that nobody can reach any more and keeps its summary alone. A failure is kept for
  // close_all().
  void retire(const Run* run) noexcept;
  // Closes every run. Throws Error with every problem there was in closing any of them.
  void close_all();
  // Of every simulation, in the order they were made.
  std::vector<Summary> summaries() const;

  // The library, read when first asked for. Throws Error (files).
  const Materials& materials();

  // Throws Error (refused) when --set was given and no options { ... } took it.
  void check_overrides_used() const;

  ConsoleSettings settings;
  Origin origin;
  std::set<std::string> declared_options;  // by options { ... }
  std::optional<int> exit_code;            // asked for with os.exit

 private:
  struct Entry {
    std::shared_ptr<Run> run;  // null once retired
    std::optional<Summary> summary;
  };
  void close(Run& run) noexcept;

  std::vector<Entry> entries_;
  std::vector<Problem> closing_problems_;
  ErrorKind closing_kind_ = ErrorKind::files;
  std::optional<Materials> materials_;
};

}  // namespace hackle
