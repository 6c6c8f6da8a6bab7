// SPDX-License-Identifier: MIT
// Runs that continue while the prompt waits for the next line. One thread does both: a run is only
// seen between two steps, functions of a script are called between steps, and a script that starts
// a run gives the same bits whenever it queries it.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> background_methods();
std::span<const Function> background_functions();

// [-0, +0] Lists the simulation at `index` in simulations() for as long as something holds it.
void remember_simulation(lua_State* L, int index);
// Frees the memory of simulations that the script no longer holds; an unfinished run is held until
// it has finished.
void collect_simulations(lua_State* L);

}  // namespace hackle
