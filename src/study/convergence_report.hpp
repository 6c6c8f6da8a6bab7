// SPDX-License-Identifier: MIT
// What a convergence study says to a person.
#pragma once

#include <string>
#include <vector>

#include "study/convergence.hpp"
#include "study/table.hpp"

namespace hackle {

// A row per quantity: its value at every level; of a place, path or field how far it is from that
// of the finest.
Table values_table(const ConvergenceAxis& axis);

// A row per quantity: order, limit, GCI and verdict.
Table verdict_table(const ConvergenceAxis& axis);

// All of it, a table and remarks per axis.
std::string text_of(const ConvergenceStudy& study);

// A sentence for everything that does not converge, with the reason where it is known, and what was
// left out.
std::vector<std::string> remarks_of(const ConvergenceAxis& axis);

// Returns which quantities converge, or do not change, on every axis, and which on none or some.
std::vector<std::string> remarks_of(const ConvergenceStudy& study);

}  // namespace hackle
