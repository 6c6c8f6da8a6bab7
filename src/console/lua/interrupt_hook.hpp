// SPDX-License-Identifier: MIT
// How Ctrl-C stops a script, whatever it does.
#pragma once

#include <optional>

#include "console/lua/lua_state.hpp"

namespace hackle {

// Why nothing of this state may go on: it is interrupted, or the script called os.exit. An error of
// kind `interrupted`.
std::optional<Error> reason_to_stop(lua_State* L);

// While an object of this class lives, a signal that asks to stop is looked for at the next
// instruction of this state, or of the coroutine that runs in it, and every 10 000 instructions;
// it is raised as an error. Every bound function looks for one too (guard.hpp).
class InterruptWatch {
 public:
  explicit InterruptWatch(lua_State* L);
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

 private:
  lua_State* state_;
  lua_State* before_;
};

// While an object of this class lives, a signal reaches this coroutine of the state that is
// watched. Null changes nothing.
class InterruptTarget {
 public:
  explicit InterruptTarget(lua_State* coroutine);
  ~InterruptTarget();
  InterruptTarget(const InterruptTarget&) = delete;
  InterruptTarget& operator=(const InterruptTarget&) = delete;

 private:
  lua_State* before_;
};

// From now on looks at every instruction: a script that catches the first error with pcall is
// stopped at its next step.
void insist_on_interrupt(lua_State* L);

}  // namespace hackle
