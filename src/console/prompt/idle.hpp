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

// Lets others work until stdin has something to read, or an end, and waits for that where nothing
// is left to do. False when the program is asked to leave instead.
bool wait_for_input(const Idle& idle, const MakeRoom& make_room);

}  // namespace hackle
