// SPDX-License-Identifier: MIT
#include "base/interrupt.hpp"

#include <atomic>
#include <csignal>
#include <string_view>

#include <unistd.h>

namespace hackle {
namespace {

// A signal handler can reach nothing but a lock-free global.
std::atomic<bool> flag{false};
static_assert(std::atomic<bool>::is_always_lock_free);

struct sigaction former_int, former_term;

void on_signal(int number) {
  if (flag.exchange(true)) {
    std::signal(number, SIG_DFL);
    std::raise(number);
    return;
  }
  constexpr std::string_view note = "\nstopping after this step (again to abort)\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, note.data(), note.size());
}

}  // namespace

bool interrupted() noexcept {
  return flag.load(std::memory_order_relaxed);
}
void request_interrupt() noexcept {
  flag.store(true);
}
void clear_interrupt() noexcept {
  flag.store(false);
}

InterruptHandler::InterruptHandler() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &former_int);
  sigaction(SIGTERM, &action, &former_term);
}

InterruptHandler::~InterruptHandler() {
  sigaction(SIGINT, &former_int, nullptr);
  sigaction(SIGTERM, &former_term, nullptr);
}

}  // namespace hackle
