// SPDX-License-Identifier: MIT
// s:values and r:values: a field of nodes as one value of a script.
#pragma once

#include <memory>
#include <span>

#include "console/lua/object.hpp"
#include "console/schema/schema.hpp"
#include "measure/node_values.hpp"

namespace hackle {

// Without values in a replay: there its methods are known by what they returned.
struct ScriptedValues {
  std::shared_ptr<const NodeValues> values;
};

template <>
inline constexpr const char* type_name<ScriptedValues> = "hackle.values";

const TypeDoc& values_type();
std::span<const Function> values_methods();           // of a simulation
std::span<const Function> recorded_values_methods();  // of a recording

}  // namespace hackle
