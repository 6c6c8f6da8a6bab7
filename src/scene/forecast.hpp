// SPDX-License-Identifier: MIT
// Whether anything on a plate can break, from an estimate that a person could make on paper.
#pragma once

#include "scene/plate.hpp"

namespace hackle {

struct Forecast {
  double stress = 0.0;        // Pa, of all loads at their strongest, doubled: waves overshoot
  double flaw = 0.0;          // m, the largest extent of a crack or half that of a cut-out
  double release_rate = 0.0;  // J/m2, G = stress^2 pi flaw / E, Griffith's for a large plate
  double toughness = 0.0;     // J/m2, the least G0 of its materials

  // The estimate is good to a factor of a few.
  enum class Verdict { nothing_loads_it, nothing_breaks, may_break, breaks };
  Verdict verdict() const;
};

// Over the first `duration` seconds. `least_flaw`, m, stands for flaws on a whole plate: its bonds
// break as if there were one of the size of the horizon. Functions of place and time are asked at
// some points and moments and may throw Error.
Forecast forecast(const Plate& plate, double duration, double least_flaw);

// "a flaw of 50 mm under up to 24 MPa releases up to 1.4 kJ/m2, G0 is 204 J/m2: it breaks"
std::string describe(const Forecast& forecast);

}  // namespace hackle
