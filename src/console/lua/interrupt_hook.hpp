// SPDX-License-Identifier: MIT
// Makes Ctrl-C stop any script.
#pragma once

#include <optional>

#include "console/lua/lua_state.hpp"

namespace hackle {

// Returns why this state must stop: an interrupt, or os.exit called by the script. The error has
// kind `interrupted`.
std::optional<Error> reason_to_stop(lua_State* L);

// While an object of this class lives, a signal that asks to stop is noticed at the next
// instruction of this state, or of the coroutine that runs in it, and checked every 10 000
// instructions; it raises an error. Every bound function checks too (guard.hpp).
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

// While an object of this class lives, a signal reaches this coroutine of the watched state. Null
// changes nothing.
class InterruptTarget {
 public:
  explicit InterruptTarget(lua_State* coroutine);
  ~InterruptTarget();
  InterruptTarget(const InterruptTarget&) = delete;
  InterruptTarget& operator=(const InterruptTarget&) = delete;

 private:
  lua_State* before_;
};

// While an object of this class lives, scripts get an error of kind `refused` after about so many
// more instructions; 0 sets no limit. An outer limit waits for the inner one.
class CallLimit {
 public:
  explicit CallLimit(long instructions);
  ~CallLimit();
  CallLimit(const CallLimit&) = delete;
  CallLimit& operator=(const CallLimit&) = delete;

 private:
  long before_;
};

// Checks at every instruction from now on: a script that catches the first error with pcall stops
// at its next step.
void insist_on_interrupt(lua_State* L);

}  // namespace hackle
