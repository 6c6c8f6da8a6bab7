// SPDX-License-Identifier: MIT
#include "base/interrupt.hpp"

#include <atomic>
#include <string_view>

#include <pthread.h>
#include <unistd.h>

#include "base/error.hpp"

namespace hackle {
namespace {

// A signal handler may only use lock-free globals.
std::atomic<bool> flag{false}, leaving{false};
std::atomic<void (*)()> alarm_of_signal{nullptr};
std::atomic<pthread_t> hearing_thread{};
static_assert(std::atomic<bool>::is_always_lock_free &&
              std::atomic<pthread_t>::is_always_lock_free);

// A closed terminal may send its signal twice. The kernel chooses any thread; the handler passes
// the signal to the thread that waits for the user.
void on_signal(int number) {
  if (!pthread_equal(pthread_self(), hearing_thread.load())) {
    pthread_kill(hearing_thread.load(), number);
    return;
  }
  if (number != SIGINT) leaving.store(true);
  if (flag.exchange(true)) {
    if (number == SIGHUP) return;
    std::signal(number, SIG_DFL);
    std::raise(number);
    return;
  }
  if (const auto alarm = alarm_of_signal.load()) alarm();
  constexpr std::string_view note = "\nstopping after this step (again to abort)\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, note.data(), note.size());
}

bool stays_ignored(int number, const struct sigaction& former) {
  return number == SIGHUP && former.sa_handler == SIG_IGN;
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
bool asked_to_leave() noexcept {
  return leaving.load(std::memory_order_relaxed);
}

void set_interrupt_alarm(void (*alarm)()) noexcept {
  alarm_of_signal.store(alarm);
}

void throw_if_interrupted() {
  if (interrupted()) throw Error(ErrorKind::interrupted, "interrupted");
}

InterruptHandler::InterruptHandler(Keyboard keyboard) {
  hearing_thread.store(pthread_self());
  struct sigaction action {};
  sigemptyset(&action.sa_mask);
  for (std::size_t k = 0; k < signals.size(); ++k) {
    sigaction(signals[k], nullptr, &former_[k]);
    if (stays_ignored(signals[k], former_[k])) continue;
    if (signals[k] == SIGINT && keyboard == Keyboard::left_alone) continue;
    action.sa_handler = on_signal;
    sigaction(signals[k], &action, nullptr);
  }
}

InterruptHandler::~InterruptHandler() {
  for (std::size_t k = 0; k < signals.size(); ++k) sigaction(signals[k], &former_[k], nullptr);
}

}  // namespace hackle
