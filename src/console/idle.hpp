// SPDX-License-Identifier: MIT
// What is done while nobody types.
#pragma once

#include <functional>

namespace hackle {

// Clears what is being typed from the screen, so that something can be said.
using MakeRoom = std::function<void()>;
// Called again and again, a moment each time; returns whether there is more to do. Calls the
// argument before it says anything.
using Idle = std::function<bool(const MakeRoom&)>;

// Until stdin has something to read, or an end, or until nothing is left to do.
void idle_until_input(const Idle& idle, const MakeRoom& make_room);

}  // namespace hackle
