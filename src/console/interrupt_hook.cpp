// SPDX-License-Identifier: MIT
#include "console/interrupt_hook.hpp"

#include <atomic>

#include "base/interrupt.hpp"
#include "console/guard.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

constexpr int instructions_between_looks = 10000;

// What runs just now; a signal handler reads it. Lua allows that it sets a hook.
std::atomic<lua_State*> running{nullptr};
static_assert(std::atomic<lua_State*>::is_always_lock_free);

void look(lua_State* L, lua_Debug*);

void look_now_and_then(lua_State* L) {
  lua_sethook(L, look, LUA_MASKCOUNT, instructions_between_looks);
}

// Calls of Lua's library may take long: counting instructions alone would not hear a signal between
// them for minutes.
void look_soon() {
  if (lua_State* L = running.load()) lua_sethook(L, look, LUA_MASKCOUNT, 1);
}

void look(lua_State* L, lua_Debug*) {
  {
    const auto reason = reason_to_stop(L);
    if (!reason) return look_now_and_then(L);
    insist_on_interrupt(L);
    push_error(L, *reason, place(L, 0));
  }
  lua_error(L);
}

lua_State* main_thread(lua_State* L) {
  lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_MAINTHREAD);
  lua_State* main = lua_tothread(L, -1);
  lua_pop(L, 1);
  return main;
}

bool is_interrupt(lua_State* L, int index) {
  const Error* error = object_at<Error>(L, index);
  return error != nullptr && error->kind() == ErrorKind::interrupted;
}

// The handler of a script, which is the first upvalue, for all other errors.
int handle(lua_State* L) {
  if (is_interrupt(L, 1)) return 1;
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, 1);
  return 1;
}

int all_results(lua_State* L, int, lua_KContext) {
  return lua_gettop(L);
}

// Lua's own is the first upvalue. What it calls may yield.
int protected_call_with_handler(lua_State* L) {
  luaL_checktype(L, 2, LUA_TFUNCTION);
  lua_pushvalue(L, 2);
  lua_pushcclosure(L, handle, 1);
  lua_replace(L, 2);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_callk(L, lua_gettop(L) - 1, LUA_MULTRET, 0, all_results);
  return all_results(L, LUA_OK, 0);
}

// Upvalues of what coroutine.wrap returns.
constexpr int coroutine_itself = 1, resume_function = 2, close_function = 3;

// The error on top of the stack comes from the coroutine: closes it, which may replace the error,
// and says where it was called.
int raise_from_coroutine(lua_State* L) {
  lua_State* coroutine = lua_tothread(L, lua_upvalueindex(coroutine_itself));
  const int status = lua_status(coroutine);
  if (status != LUA_OK && status != LUA_YIELD && !is_interrupt(L, -1)) {
    lua_pushvalue(L, lua_upvalueindex(close_function));
    lua_pushvalue(L, lua_upvalueindex(coroutine_itself));
    lua_call(L, 1, 2);
    if (lua_isnil(L, -1)) lua_pop(L, 2);  // no error that replaces it
  }
  if (status != LUA_ERRMEM && lua_type(L, -1) == LUA_TSTRING) {
    luaL_where(L, 1);
    lua_insert(L, -2);
    lua_concat(L, 2);
  }
  return lua_error(L);
}

// While a coroutine runs, it is what a signal reaches.
class Inside {
 public:
  explicit Inside(lua_State* coroutine) : before_(running.load()) {
    if (coroutine != nullptr) running.store(coroutine);
  }
  ~Inside() { running.store(before_); }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

 private:
  lua_State* before_;
};

int go_on_with_coroutine(lua_State* L) {
  const Inside inside(lua_tothread(L, lua_upvalueindex(coroutine_itself)));
  lua_pushvalue(L, lua_upvalueindex(resume_function));
  lua_pushvalue(L, lua_upvalueindex(coroutine_itself));
  lua_rotate(L, 1, 2);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  if (lua_toboolean(L, 1) == 0) return raise_from_coroutine(L);
  return lua_gettop(L) - 1;
}

// Lua's create, resume and close are the upvalues.
int wrap(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_pushvalue(L, 1);
  lua_call(L, 1, 1);
  lua_pushvalue(L, lua_upvalueindex(2));
  lua_pushvalue(L, lua_upvalueindex(3));
  lua_pushcclosure(L, guarded<go_on_with_coroutine>, 3);
  return 1;
}

int resume_coroutine(lua_State* L) {
  const Inside inside(lua_tothread(L, 1));
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
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

void insist_on_interrupt(lua_State* L) {
  lua_sethook(L, look, LUA_MASKCOUNT, 1);
  lua_sethook(main_thread(L), look, LUA_MASKCOUNT, 1);
}

void open_interruptible(lua_State* L) {
  lua_getglobal(L, "xpcall");
  lua_pushcclosure(L, protected_call_with_handler, 1);
  lua_setglobal(L, "xpcall");
  lua_getglobal(L, "coroutine");
  lua_getfield(L, -1, "create");
  lua_getfield(L, -2, "resume");
  lua_getfield(L, -3, "close");
  lua_pushcclosure(L, wrap, 3);
  lua_setfield(L, -2, "wrap");
  lua_getfield(L, -1, "resume");
  lua_pushcclosure(L, guarded<resume_coroutine>, 1);
  lua_setfield(L, -2, "resume");
  lua_pop(L, 1);
}

}  // namespace hackle
