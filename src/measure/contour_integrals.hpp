// SPDX-License-Identifier: MIT
// J and the interaction integrals of a crack, over rings of nodes around its tip. They are taken
// from the bonds, without a stress (src/measure/README.md 1).
#pragma once

#include <vector>

#include "measure/tip_frame.hpp"
#include "measure/williams.hpp"
#include "solver/view.hpp"

namespace hackle {

// A ring around a tip: the weight of a node falls from 1 at `radius` - `width`/2 to 0 at `radius` +
// `width`/2, so that an integral over it is the mean of those along many contours. m.
struct ContourRing {
  double radius = 0.0;
  double width = 0.0;

  double inner() const { return radius - 0.5 * width; }
  double outer() const { return radius + 0.5 * width; }
  double weight(double distance) const;  // 0..1
};

struct RingIntegrals {
  double J = 0.0;                // J/m2, energy that flows into the ring per length of crack
  double K_I = 0.0, K_II = 0.0;  // Pa sqrt(m), by the interaction with Williams' singular fields
};

// Computes the integrals over each ring. Inner edges must be at least a horizon away from the tip.
std::vector<RingIntegrals> ring_integrals(const View& view, const TipFrame& frame,
                                          const std::vector<ContourRing>& rings,
                                          const PlaneModuli& moduli);

}  // namespace hackle
