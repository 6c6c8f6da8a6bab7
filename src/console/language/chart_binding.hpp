// SPDX-License-Identifier: MIT
// Charts of the numbers of runs.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> chart_functions();         // chart
std::span<const Function> chart_methods();           // s:chart
std::span<const Function> recorded_chart_methods();  // r:chart

}  // namespace hackle
