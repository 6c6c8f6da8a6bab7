// SPDX-License-Identifier: MIT
// Ctrl-C as one atomic flag, which every long loop reads between two steps.
#pragma once

#include <array>
#include <csignal>

namespace hackle {

// Returns true after SIGINT, SIGTERM or SIGHUP, or after request_interrupt(), until
// clear_interrupt().
bool interrupted() noexcept;
void request_interrupt() noexcept;
void clear_interrupt() noexcept;

// Throws Error (interrupted) if interrupted(): for loops that have nothing to complete.
void throw_if_interrupted();

// Sets a function that the handler of these signals also calls; it must be async-signal-safe. It
// runs in the thread that made the InterruptHandler. Null removes it.
void set_interrupt_alarm(void (*alarm)()) noexcept;

// Returns true once SIGTERM or SIGHUP has arrived, and stays true: the whole program is to end, not
// only the work in progress.
bool asked_to_leave() noexcept;

// While an object of this class lives, SIGINT, SIGTERM and SIGHUP set the flag and report it on
// stderr; a second SIGINT or SIGTERM ends the process at once. A SIGHUP that was ignored stays
// ignored (nohup). The destructor restores the former handlers.
class InterruptHandler {
 public:
  enum class Keyboard { heard, left_alone };  // SIGINT
  explicit InterruptHandler(Keyboard keyboard = Keyboard::heard);
  ~InterruptHandler();
  InterruptHandler(const InterruptHandler&) = delete;
  InterruptHandler& operator=(const InterruptHandler&) = delete;

 private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, signals.size()> former_;
};

}  // namespace hackle
