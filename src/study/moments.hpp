// SPDX-License-Identifier: MIT
// Times at which runs are compared.
#pragma once

#include "study/case.hpp"

namespace hackle {

// Returns when the displacements of runs are compared, s: shortly before the first bond breaks in
// this run, or in the middle of it if none does.
double moment_of_comparison(const Outcome& outcome);

}  // namespace hackle
