// SPDX-License-Identifier: MIT
// Runs that go on while the prompt waits for the next line. One thread does both: a run is only
// ever seen between two steps, functions of a script are called between them, and a script that
// starts a run gives the same bits whenever it is asked for.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> background_methods();
std::span<const Function> background_functions();

// [-0, +0] The simulation at `index` is in simulations() as long as somebody holds it.
void remember_simulation(lua_State* L, int index);
// Simulations that the script has let go of give back their memory; what is under way is held until
// it has arrived.
void collect_simulations(lua_State* L);

}  // namespace hackle
