// SPDX-License-Identifier: MIT
#include "console/lua/interrupt_hook.hpp"

#include <algorithm>
#include <atomic>

#include "base/interrupt.hpp"
#include "console/lua/error_object.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

constexpr int instructions_between_looks = 10000;

// The state or coroutine that runs; the signal handler reads it. Lua allows a handler to set a
// hook.
std::atomic<lua_State*> running{nullptr};
static_assert(std::atomic<lua_State*>::is_always_lock_free);

// Looks until the limit of the call that runs; none if negative.
thread_local long looks_left = -1;

void look(lua_State* L, lua_Debug*);

void look_now_and_then(lua_State* L) {
  lua_sethook(L, look, LUA_MASKCOUNT, instructions_between_looks);
}

// Calls of Lua's library may take long: counting instructions alone might not notice a signal for
// minutes.
void look_soon() {
  if (lua_State* L = running.load()) lua_sethook(L, look, LUA_MASKCOUNT, 1);
}

bool is_beyond_limit() {
  if (looks_left < 0) return false;
  looks_left = std::max(0L, looks_left - 1);
  return looks_left == 0;
}

void look(lua_State* L, lua_Debug*) {
  {
    const auto reason = reason_to_stop(L);
    const bool endless = !reason && is_beyond_limit();
    if (!reason) look_now_and_then(L);
    if (!reason && !endless) return;
    if (reason) insist_on_interrupt(L);
    push_error(L,
               reason ? *reason
                      : Error(ErrorKind::refused, "it does not return",
                              "look for a loop without an end: one value must not take long"),
               place(L, 0));
  }
  lua_error(L);
}

lua_State* main_thread(lua_State* L) {
  lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_MAINTHREAD);
  lua_State* main = lua_tothread(L, -1);
  lua_pop(L, 1);
  return main;
}

}  // namespace

std::optional<Error> reason_to_stop(lua_State* L) {
  const Session* session = find_session(L);
  const bool leaving = session != nullptr && session->exit_code.has_value();
  if (!leaving && !interrupted()) return std::nullopt;
  return Error(ErrorKind::interrupted, leaving ? "os.exit" : "interrupted");
}

InterruptWatch::InterruptWatch(lua_State* L) : state_(L), before_(running.exchange(L)) {
  look_now_and_then(L);
  set_interrupt_alarm(look_soon);
}

InterruptWatch::~InterruptWatch() {
  running.store(before_);
  look_now_and_then(state_);
}

CallLimit::CallLimit(long instructions) : before_(looks_left) {
  looks_left = instructions > 0 ? std::max(1L, instructions / instructions_between_looks) : -1;
}

CallLimit::~CallLimit() {
  looks_left = before_;
}

InterruptTarget::InterruptTarget(lua_State* coroutine) : before_(running.load()) {
  if (coroutine != nullptr) running.store(coroutine);
}

InterruptTarget::~InterruptTarget() {
  running.store(before_);
}

void insist_on_interrupt(lua_State* L) {
  lua_sethook(L, look, LUA_MASKCOUNT, 1);
  lua_sethook(main_thread(L), look, LUA_MASKCOUNT, 1);
}

}  // namespace hackle
