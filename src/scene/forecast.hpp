// SPDX-License-Identifier: MIT
// Forecasts whether anything on a plate can break, by an estimate that fits on paper.
#pragma once

#include "scene/plate.hpp"

namespace hackle {

// Dynamic overshoot: factor on the stress of a suddenly applied load.
inline constexpr double overshoot = 2.0;

// A period during which no load is exchanged.
struct Episode {
  double begin = 0.0;  // s
  double end = 0.0;    // s
  // s, when these loads were applied; displacement of velocity supports counts from here
  double since = 0.0;
  bool slow = false;    // quasi-static, without waves
  double stored = 0.0;  // Pa, stress left by the loads before these; when released, it oscillates
};

struct Forecast {
  double stress = 0.0;        // Pa, all loads at their maximum; doubled where waves overshoot
  double flaw = 0.0;          // m, the largest extent of a crack or half that of a cut-out
  double release_rate = 0.0;  // J/m2, G = stress^2 pi flaw / E (Griffith, large plate)
  double toughness = 0.0;     // J/m2, the smallest G0 of the plate's materials

  bool sampled = false;  // functions were sampled at some places and times

  // The estimate is good to a factor of a few.
  enum class Verdict { nothing_loads_it, nothing_breaks, may_break, breaks };
  Verdict verdict() const;
};

// Estimates what breaks during an episode. `min_flaw` (m) stands for flaws of a plate without any:
// its bonds break as if it had one of the size of the horizon. Initial conditions count in an
// episode that begins at 0. Functions of place and time are sampled and may throw Error.
Forecast forecast(const Plate& plate, const Episode& episode, double min_flaw);

// Returns "a flaw of 50 mm under up to 24 MPa releases up to 1.4 kJ/m2, G0 is 204 J/m2: it breaks".
std::string describe(const Forecast& forecast);

}  // namespace hackle
