// SPDX-License-Identifier: MIT
// Ctrl-C as one atomic flag that every long loop reads between two steps.
#pragma once

#include <array>
#include <csignal>

namespace hackle {

// True once SIGINT, SIGTERM or SIGHUP arrived, or request_interrupt() was called, until
// clear_interrupt().
bool interrupted() noexcept;
void request_interrupt() noexcept;
void clear_interrupt() noexcept;

// Throws Error (interrupted) if so: for loops that have nothing to complete.
void throw_if_interrupted();

// What else a signal that asks to stop is to do, in its handler: must be async-signal-safe. It is
// called in the thread that made the InterruptHandler. Null: nothing.
void set_interrupt_alarm(void (*alarm)()) noexcept;

// True for ever once SIGTERM or SIGHUP arrived: the program is to end, not what it does just now.
bool asked_to_leave() noexcept;

// While an object of this class lives, SIGINT, SIGTERM and SIGHUP set the flag and say so on
// stderr; a second SIGINT or SIGTERM ends the process at once. A SIGHUP that was ignored stays so
// (nohup). The former handlers come back afterwards.
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
