// SPDX-License-Identifier: MIT
#include "base/streams.hpp"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "base/interrupt.hpp"

namespace hackle {
namespace {

std::atomic<int> first_failure{0};  // errno of stdout

// The signal reaches the thread that writes.
thread_local volatile std::sig_atomic_t writes_messages = 0;

// Messages that nobody reads are no reason to stop, even if nobody reads the output either.
void on_broken_pipe(int) {
  const int before = errno;
  if (writes_messages == 0 && output_is_unread()) request_interrupt();
  errno = before;
}

// Opens the descriptor for reading in every case: writing to it then fails, and the loss is
// reported.
void open_where_closed(int descriptor) {
  if (fcntl(descriptor, F_GETFD) >= 0) return;
  const int opened = open("/dev/null", O_RDONLY);  // the lowest free descriptor
  if (opened < 0 || opened == descriptor) return;
  dup2(opened, descriptor);
  close(opened);
}

void remember_failure(std::FILE* stream) noexcept {
  int none = 0;
  if (stream == stdout) first_failure.compare_exchange_strong(none, errno);
}

}  // namespace

void hold_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    open_where_closed(descriptor);
  struct sigaction action {};
  action.sa_handler = on_broken_pipe;  // programs that a script starts get the default action again
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGPIPE, &action, nullptr);
  action.sa_handler = [](int) {};  // a file at its size limit becomes a write error
  sigaction(SIGXFSZ, &action, nullptr);
}

void write_to(std::FILE* stream, std::string_view text) noexcept {
  const std::sig_atomic_t before = writes_messages;
  writes_messages = stream == stderr ? 1 : 0;
  if (std::fwrite(text.data(), 1, text.size(), stream) != text.size()) remember_failure(stream);
  writes_messages = before;
}

void flush(std::FILE* stream) noexcept {
  if (std::fflush(stream) != 0) remember_failure(stream);
}

std::optional<std::string> lost_output() noexcept {
  flush(stdout);
  if (const int failure = first_failure) return std::strerror(failure);
  if (std::ferror(stdout) != 0) return "it could not be written";
  return std::nullopt;
}

bool output_is_unread() noexcept {
  pollfd output{.fd = STDOUT_FILENO, .events = 0, .revents = 0};
  return poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0;
}

}  // namespace hackle
