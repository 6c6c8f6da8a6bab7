// SPDX-License-Identifier: MIT
// The findings of a convergence study: JSON, a table of numbers, and charts.
#pragma once

#include <nlohmann/json.hpp>

#include "render/diagram/diagram.hpp"
#include "study/convergence.hpp"
#include "study/study_files.hpp"
#include "study/table.hpp"

namespace hackle {

// {"schema":1,"kind":"convergence","axes":[{"axis":"delta","levels":[...],"quantities":{...}}]}
nlohmann::ordered_json to_json(const ConvergenceStudy& study);

// A row per axis, quantity and level, in SI units.
Table numbers_of(const ConvergenceStudy& study);

// Distances to the finest level over the size, log-log: of numbers as a share of the finest, and of
// fields; of places and paths in m.
Diagram errors_of(const ConvergenceAxis& axis);
Diagram moves_of(const ConvergenceAxis& axis);

// Numbers over the size, each as a multiple of that at the finest level.
Diagram values_of(const ConvergenceAxis& axis);

// All of it, with charts delta-error, delta-places and delta-values for each axis, of more than
// five curves each with a second, -2.
StudyFindings findings_of(const ConvergenceStudy& study);

}  // namespace hackle
