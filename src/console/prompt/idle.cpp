// SPDX-License-Identifier: MIT
#include "console/prompt/idle.hpp"

#include <poll.h>
#include <unistd.h>

#include "base/interrupt.hpp"

namespace hackle {
namespace {

constexpr int moment = 200;  // ms; a signal just before poll() is noticed after it

bool has_input(int milliseconds) {
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  return poll(&input, 1, milliseconds) > 0;
}

}  // namespace

bool wait_for_input(const Idle& idle, const MakeRoom& make_room) {
  for (bool more = true; !asked_to_leave();) {
    if (has_input(more ? 0 : moment)) return true;
    more = idle && idle(make_room);
  }
  return false;
}

}  // namespace hackle
