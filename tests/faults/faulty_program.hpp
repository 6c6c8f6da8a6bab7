// SPDX-License-Identifier: MIT
// The program in a broken environment.
#pragma once

#include <array>
#include <chrono>
#include <csignal>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/program.hpp"

namespace hackle::test {

// The target of stdin, stdout or stderr: a file, nothing, a full disk, a pipe whose other end is
// closed.
enum class Stream { usual, closed, full, unread };
using Streams = std::array<Stream, 3>;

struct Fault {
  Streams streams{};
  std::vector<std::pair<__rlimit_resource, rlim_t>> limits = {};
  std::vector<int> ignored = {};              // signals
  std::function<void(pid_t)> meanwhile = {};  // called once the program has started
};

class FaultyProgram {
 public:
  // A program that runs longer counts as hanging and is ended, which its exit code shows.
  static constexpr unsigned max_seconds = 100;

  explicit FaultyProgram(const Folder& folder) : folder_(folder.path) {}

  Ended run(const std::vector<std::string>& words, const Fault& fault = {}) const {
    for (const char* name : {".stdin", ".stdout", ".stderr"})
      close(open((folder_ / name).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600));
    const pid_t child = fork();
    if (child == 0) become(words, fault);
    if (fault.meanwhile) fault.meanwhile(child);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            Program::text_of(folder_ / ".stdout"), Program::text_of(folder_ / ".stderr")};
  }

  // Waits until the program has printed "go".
  void wait_for_go() const {
    wait_until([this] { return Program::text_of(folder_ / ".stdout").starts_with("go"); });
  }
  void wait_for_file(const std::string& name) const {
    wait_until([&] { return std::filesystem::exists(folder_ / name); });
  }

 private:
  static void wait_until(const std::function<bool()>& arrived) {
    for (int tries = 0; tries < 4000 && !arrived(); ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }

  static void put(Stream stream, int descriptor, const char* usual) {
    const int mode = descriptor == STDIN_FILENO ? O_RDONLY : O_WRONLY | O_APPEND;
    if (stream == Stream::closed) close(descriptor);
    if (stream == Stream::usual) dup2(open(usual, mode), descriptor);
    if (stream == Stream::full) dup2(open("/dev/full", O_RDWR), descriptor);
    if (stream != Stream::unread) return;
    int ends[2];
    if (pipe(ends) != 0) _exit(97);
    dup2(ends[1], descriptor);
    close(ends[0]);
    close(ends[1]);
  }

  [[noreturn]] void become(const std::vector<std::string>& words, const Fault& fault) const {
    std::vector<char*> arguments{const_cast<char*>(HACKLE_PROGRAM)};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    if (chdir(folder_.c_str()) != 0) _exit(99);
    alarm(max_seconds);
    for (int number : fault.ignored) std::signal(number, SIG_IGN);
    for (const auto& [resource, max] : fault.limits) {
      const rlimit limit{max, max};
      setrlimit(resource, &limit);
    }
    const std::array<const char*, 3> names{".stdin", ".stdout", ".stderr"};
    for (int k = 2; k >= 0; --k) put(fault.streams[k], k, names[k]);
    for (int other = 3; other < 64; ++other) close(other);
    execv(arguments[0], arguments.data());
    _exit(98);
  }

  std::filesystem::path folder_;
};

}  // namespace hackle::test
