// SPDX-License-Identifier: MIT
// Work done while nobody types.
#pragma once

#include <functional>

namespace hackle {

// Clears the typed line from the screen, so that a message can be printed.
using MakeRoom = std::function<void()>;
// Called repeatedly, briefly each time; returns whether there is more to do. Calls its argument
// before it prints anything.
using Idle = std::function<bool(const MakeRoom&)>;

// Calls `idle` until stdin has input or has ended; once `idle` has nothing left to do, only waits.
// Returns false if the program is asked to leave meanwhile.
bool wait_for_input(const Idle& idle, const MakeRoom& make_room);

}  // namespace hackle
