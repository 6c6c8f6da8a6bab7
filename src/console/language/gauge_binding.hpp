// SPDX-License-Identifier: MIT
// Gauges on a plate, as values of scripts: gauge { ... }, s:read.
#pragma once

#include <memory>
#include <span>

#include "console/lua/object.hpp"
#include "console/schema/schema.hpp"
#include "measure/gauge.hpp"

namespace hackle {

struct ScriptedGauge {
  std::shared_ptr<const Gauge> gauge;
};

template <>
inline constexpr const char* type_name<ScriptedGauge> = "hackle.gauge";

const TypeDoc& gauge_type();
std::span<const Function> gauge_functions();
std::span<const Function> gauge_methods();           // of a simulation
std::span<const Function> recorded_gauge_methods();  // of a recording

}  // namespace hackle
