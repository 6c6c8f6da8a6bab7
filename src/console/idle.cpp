// SPDX-License-Identifier: MIT
#include "console/idle.hpp"

#include <poll.h>
#include <unistd.h>

namespace hackle {
namespace {

bool has_input() {
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  return poll(&input, 1, 0) != 0;
}

}  // namespace

void idle_until_input(const Idle& idle, const MakeRoom& make_room) {
  while (!has_input() && idle(make_room)) {
  }
}

}  // namespace hackle
