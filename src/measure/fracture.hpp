// SPDX-License-Identifier: MIT
// What drives a crack: J over several rings around its tip, and the stress intensities in three
// ways that check each other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/clearance.hpp"
#include "measure/contour_integrals.hpp"
#include "measure/tip_frame.hpp"
#include "measure/williams.hpp"
#include "solver/view.hpp"

namespace hackle {

struct FractureOptions {
  std::optional<Vec2> tip;    // m; without it foremost_tip() along `along`
  std::optional<Vec2> ahead;  // any length; without it direction_at() the tip
  Vec2 along{1.0, 0.0};       // any length
  std::vector<double> radii;  // m, of the rings, each at least two horizons; empty: four from 1.5
                              // horizons to 10, or as far as the plate is clear all round, or, if
                              // that is below 2.5, along the crack
  std::string who = "fracture";  // for messages
};

struct Fracture {
  TipFrame frame;
  Clearance clear;
  std::vector<ContourRing> rings;
  std::vector<RingIntegrals> on_rings;
  double G0 = 0.0;                      // J/m2, of a straight cut ahead, of the material at the tip
  PlaneModuli moduli;                   // of that material
  std::optional<WilliamsFit> williams;  // from the inner edge of the rings as far as they reach and
                                        // the plate is clear all round; nothing below a horizon

  double J() const;       // J/m2, mean of the rings
  double spread() const;  // their largest J less the smallest, over the mean; 0 if J is 0
  // Pa sqrt(m), mean of the interaction integrals over the rings within which the plate is clear
  // all round; nothing without such a ring.
  std::optional<double> K_I() const;
  std::optional<double> K_II() const;
  double K_J() const;  // Pa sqrt(m), sqrt(E' J): both modes together; 0 where J is negative
};

// Throws Error (refused) without a crack or a direction, for a tip off the plate, where nothing is
// open behind the tip, for radii below two horizons, and if less than 2.5 horizons are clear
// without radii.
Fracture fracture(const View& view, const FractureOptions& options);

// The same for tables: nothing where that is refused.
std::optional<Fracture> fracture_if_any(const View& view, const FractureOptions& options);

}  // namespace hackle
