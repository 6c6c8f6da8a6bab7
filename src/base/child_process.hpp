// SPDX-License-Identifier: MIT
// Programs that run beside this one: what they print, and what they cost.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace hackle {

// What became of a program.
struct ChildResult {
  int exit_code = 0;  // 128 plus the signal that ended it, as in a shell
  bool timed_out = false;
  std::string out;               // all of its stdout
  std::string error;             // the end of its stderr, at most 16 kB
  double wall = 0.0;             // s
  double cpu = 0.0;              // s, user and system
  std::uint64_t peak_bytes = 0;  // largest resident size

  bool succeeded() const { return exit_code == 0 && !timed_out; }
};

// A running program. It reads nothing, it ends when this program ends, and it does not see what
// mpirun, srun or a job array has told this process of its place (base/ranks/launcher.hpp).
class ChildProcess {
 public:
  // Starts `words[0]`, a path, with the rest as its arguments. It is killed after `time_limit`, s
  // of wall time. It keeps the descriptor `shared` open too, and so holds a lock (flock) on that
  // file until both programs have ended; -1: none. Throws Error (run_failed) if it cannot be
  // started.
  explicit ChildProcess(const std::vector<std::string>& words,
                        double time_limit = std::numeric_limits<double>::infinity(),
                        int shared = -1);
  // Kills it if it still runs.
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;

  // Returns the result once it has ended; before that, nothing. Call it no more afterwards.
  std::optional<ChildResult> poll();

 private:
  using Clock = std::chrono::steady_clock;
  // A file without a name that takes what the program prints.
  struct Sink {
    int descriptor = -1;
    Sink();
    ~Sink();
    Sink(Sink&& other) noexcept;
    std::string text(std::size_t last) const;
  };

  double age() const;

  Sink out_, error_;
  pid_t id_ = -1;
  double time_limit_;
  bool timed_out_ = false;
  Clock::time_point start_ = Clock::now();
};

// Runs a program to its end. Throws the same, and Error (interrupted), which kills it.
ChildResult run_child(const std::vector<std::string>& words,
                      double time_limit = std::numeric_limits<double>::infinity());

// Returns the path of the program that is running. Throws Error (run_failed).
std::filesystem::path this_program();

}  // namespace hackle
