// SPDX-License-Identifier: MIT
// Whether anything on a plate can break, from an estimate that a person could make on paper.
#pragma once

#include "scene/plate.hpp"

namespace hackle {

// What waves make of a load that is put on at once.
inline constexpr double overshoot = 2.0;

// A while in which loads are not exchanged.
struct Episode {
  double begin = 0.0;   // s
  double end = 0.0;     // s
  double since = 0.0;   // s, when these loads were put on: velocities of supports lead from there
  bool slow = false;    // at rest at every moment: there are no waves
  double stored = 0.0;  // Pa, what the loads before these left in the plate: let go of, it swings
};

struct Forecast {
  double stress = 0.0;        // Pa, of all loads at their strongest; doubled where waves overshoot
  double flaw = 0.0;          // m, the largest extent of a crack or half that of a cut-out
  double release_rate = 0.0;  // J/m2, G = stress^2 pi flaw / E, Griffith's for a large plate
  double toughness = 0.0;     // J/m2, the least G0 of its materials

  bool sampled = false;  // functions were asked at some places and moments

  // The estimate is good to a factor of a few.
  enum class Verdict { nothing_loads_it, nothing_breaks, may_break, breaks };
  Verdict verdict() const;
};

// `min_flaw`, m, stands for flaws on a whole plate: its bonds break as if there were one of the
// size of the horizon. What sets the plate in motion counts in an episode that begins at 0.
// Functions of place and time are asked at some points and moments and may throw Error.
Forecast forecast(const Plate& plate, const Episode& episode, double min_flaw);

// "a flaw of 50 mm under up to 24 MPa releases up to 1.4 kJ/m2, G0 is 204 J/m2: it breaks"
std::string describe(const Forecast& forecast);

}  // namespace hackle
