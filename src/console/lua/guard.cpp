// SPDX-License-Identifier: MIT
#include "console/lua/guard.hpp"

#include <exception>
#include <optional>

#include "console/lua/interrupt_hook.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

// Returns the Error that the function threw. Otherwise returns nothing and sets `results` to its
// number of results.
std::optional<Error> attempt(lua_State* L, Binding function, const void* what, int& results) {
  try {
    if (auto reason = reason_to_stop(L)) return reason;
    results = call_replayed(L, function, what);
    return std::nullopt;
  } catch (const Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return Error(ErrorKind::run_failed, "out of memory");
  } catch (const std::exception& error) {
    return Error(ErrorKind::run_failed, error.what());
  }
}

}  // namespace

int call_replayed(lua_State* L, Binding function, const void* what) {
  const Session* session = find_session(L);
  if (session == nullptr || !session->checkpoints) return function(L);
  return session->checkpoints->replay().call(L, what, function);
}

int call_guarded(lua_State* L, Binding function, const void* what) {
  int results = 0;
  {
    const std::optional<Error> thrown = attempt(L, function, what, results);
    if (!thrown) return results;
    if (thrown->kind() == ErrorKind::interrupted) insist_on_interrupt(L);
    lua_settop(L, 0);
    push_error(L, *thrown, place(L, 1));
  }
  return lua_error(L);
}

}  // namespace hackle
