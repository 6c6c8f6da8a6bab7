// SPDX-License-Identifier: MIT
// Ctrl-C as one atomic flag that every long loop reads between two steps.
#pragma once

namespace hackle {

// True once SIGINT or SIGTERM arrived, or request_interrupt() was called, until clear_interrupt().
bool interrupted() noexcept;
void request_interrupt() noexcept;
void clear_interrupt() noexcept;

// While an object of this class lives, SIGINT and SIGTERM set the flag and say so on stderr; a
// second signal ends the process at once. The former handlers come back afterwards.
class InterruptHandler {
 public:
  InterruptHandler();
  ~InterruptHandler();
  InterruptHandler(const InterruptHandler&) = delete;
  InterruptHandler& operator=(const InterruptHandler&) = delete;
};

}  // namespace hackle
