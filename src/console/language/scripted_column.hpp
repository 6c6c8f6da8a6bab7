// SPDX-License-Identifier: MIT
// A column of a table as a script gives it.
#pragma once

#include <any>
#include <optional>
#include <string>
#include <vector>

#include "console/lua/lua_function.hpp"
#include "console/replay/replay.hpp"
#include "console/schema/given_value.hpp"
#include "measure/gauge.hpp"
#include "measure/quantity.hpp"

namespace hackle {

// The name of a column that Hackle knows, a function of the script with the name that it gave, or a
// gauge.
struct ScriptedColumn {
  std::string name;
  std::optional<LuaFunction> function{};
  std::optional<Gauge> gauge{};
};
using ScriptedColumns = std::vector<ScriptedColumn>;

// Reads names, functions, gauges and {name = function}. A function is called with the object of the
// call, at index 1 of the stack, which it does not keep alive.
std::any read_columns(const GivenValue& given);

// Returns the columns of a recording. Throws what column_named() and check_on() throw.
std::vector<Column> columns_of(const ScriptedColumns& given, const View& view);
// Returns the same of a run: where the script keeps checkpoints, calls of its functions are events
// of the replay, which may be null.
std::vector<Column> columns_of(const ScriptedColumns& given, const Run& run, Replay* replay);

}  // namespace hackle
