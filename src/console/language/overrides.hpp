// SPDX-License-Identifier: MIT
// Values given on the command line: --set key=value for an option of the script,
// --set simulate.key=value for an option of every simulate { ... }, or movie.key of every movie,
// --set material.key=value for the material of every plate that is simulated, --set
// scatter.key=value for the scatter of its strength. The value `default` takes what the script
// gives away.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "console/language/override_keys.hpp"

struct lua_State;

namespace hackle {

struct FunctionDoc;
struct Material;
struct Plate;
class Problems;
class Session;

// [-0, +0] Evaluates a value as written on a command line, such as 24MPa; returns nothing if it
// gives no finite number.
std::optional<double> shell_number(lua_State* L, std::string_view text);

// [-0, +0] Replaces the table at `index`, counted from the bottom, by a copy of it.
void copy_table(lua_State* L, int index);

// [-0, +0] Replaces the table at `index` by a copy that has the values set with this prefix.
// Whoever reads it finds what is wrong with them.
void set_overrides(lua_State* L, int index, std::string_view prefix, const Session& session);

// [-0, +0] Sets the members of the material that --set names. Adds a problem for each that does not
// exist, is no number, or is out of range.
void override_material(lua_State* L, const Session& session, Material& material,
                       Problems& problems);

// [-0, +0] Scatters the strength of the plate as --set names: scatter.modulus makes a Weibull
// distribution, scatter.deviation a normal one; scatter.seed and scatter.correlation alone change
// the scatter that the plate has. Adds a problem for what does not exist, is no number, is out of
// range, or changes the scatter of a plate that has none.
void override_scatter(lua_State* L, const Session& session, Plate& plate, Problems& problems);

}  // namespace hackle
