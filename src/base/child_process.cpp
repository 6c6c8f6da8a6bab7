// SPDX-License-Identifier: MIT
#include "base/child_process.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/ranks/launcher.hpp"

namespace hackle {
namespace {

constexpr std::size_t error_kept = 16384;  // bytes
constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
constexpr auto pause_between_polls = std::chrono::milliseconds(2);

[[noreturn]] void fail_to_start(const std::string& program, int reason) {
  throw Error(ErrorKind::run_failed,
              fmt::format("cannot start '{}': {}", program, std::strerror(reason)));
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// The environment of this process without its place among others. It ends with a null.
std::vector<char*> environment_of_child() {
  std::vector<char*> kept;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    if (!is_of_launcher(text.substr(0, text.find('=')))) kept.push_back(*variable);
  }
  kept.push_back(nullptr);
  return kept;
}

// What a child keeps of its parent.
struct Inherited {
  char* const* environment;
  int out, error, shared;
};

// In the child, between fork and exec: only calls that are async-signal-safe.
[[noreturn]] void become(char* const* words, const Inherited& inherited, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // it has ended in between
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(nothing, STDIN_FILENO);
  dup2(inherited.out, STDOUT_FILENO);
  dup2(inherited.error, STDERR_FILENO);
  if (inherited.shared >= 0) fcntl(inherited.shared, F_SETFD, 0);
  execve(words[0], words, inherited.environment);
  _exit(127);
}

}  // namespace

ChildProcess::Sink::Sink() : descriptor(memfd_create("child", MFD_CLOEXEC)) {
  if (descriptor < 0) fail_to_start("a program", errno);
}

ChildProcess::Sink::~Sink() {
  if (descriptor >= 0) close(descriptor);
}

ChildProcess::Sink::Sink(Sink&& other) noexcept : descriptor(std::exchange(other.descriptor, -1)) {
}

std::string ChildProcess::Sink::text(std::size_t last) const {
  const auto size = static_cast<std::size_t>(std::max<off_t>(lseek(descriptor, 0, SEEK_END), 0));
  const std::size_t count = std::min(size, last);
  std::string text(count, '\0');
  std::size_t done = 0;
  while (done < count) {
    const ssize_t read = pread(descriptor, text.data() + done, count - done,
                               static_cast<off_t>(size - count + done));
    if (read <= 0) break;
    done += static_cast<std::size_t>(read);
  }
  text.resize(done);
  return text;
}

ChildProcess::ChildProcess(const std::vector<std::string>& words, double time_limit, int shared)
    : time_limit_(time_limit) {
  if (words.empty() || access(words[0].c_str(), X_OK) != 0)
    fail_to_start(words.empty() ? "" : words[0], words.empty() ? ENOENT : errno);
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  const std::vector<char*> environment = environment_of_child();
  const pid_t parent = getpid();
  id_ = fork();
  if (id_ < 0) fail_to_start(words[0], errno);
  if (id_ == 0)
    become(pointers.data(), {environment.data(), out_.descriptor, error_.descriptor, shared},
           parent);
}

ChildProcess::~ChildProcess() {
  if (id_ <= 0) return;
  kill(id_, SIGKILL);
  waitpid(id_, nullptr, 0);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : out_(std::move(other.out_)),
      error_(std::move(other.error_)),
      id_(std::exchange(other.id_, -1)),
      time_limit_(other.time_limit_),
      timed_out_(other.timed_out_),
      start_(other.start_) {
}

double ChildProcess::age() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

std::optional<ChildResult> ChildProcess::poll() {
  if (!timed_out_ && age() > time_limit_) {
    timed_out_ = true;
    kill(id_, SIGKILL);
  }
  int status = 0;
  rusage usage{};
  const pid_t ended = wait4(id_, &status, WNOHANG, &usage);
  if (ended == 0 || (ended < 0 && errno == EINTR)) return std::nullopt;
  id_ = -1;
  ChildResult result;
  result.wall = age();
  result.exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  result.timed_out = timed_out_;
  result.out = out_.text(all);
  result.error = error_.text(error_kept);
  result.cpu = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  result.peak_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024U;
  return result;
}

ChildResult run_child(const std::vector<std::string>& words, double time_limit) {
  ChildProcess child(words, time_limit);
  while (true) {
    throw_if_interrupted();
    if (std::optional<ChildResult> result = child.poll()) return *std::move(result);
    std::this_thread::sleep_for(pause_between_polls);
  }
}

std::filesystem::path this_program() {
  std::error_code failure;
  std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", failure);
  if (failure) throw Error(ErrorKind::run_failed, "the program does not know its own path");
  return path;
}

}  // namespace hackle
