// SPDX-License-Identifier: MIT
// The fields around the tip of a crack in an elastic plane: Williams' series, and its fit to the
// displacements of nodes.
#pragma once

#include <optional>

#include "measure/tip_frame.hpp"
#include "solver/view.hpp"

namespace hackle {

// Moduli of the plane in which a plate is elastic, those of its lattice averaged over all
// directions; in plane stress kappa = (3 - nu)/(1 + nu), in plane strain 3 - 4 nu.
struct PlaneModuli {
  double shear = 0.0;  // Pa
  double kappa = 0.0;

  // Returns E', Pa, of G = (K_I^2 + K_II^2)/E': E in plane stress, E/(1 - nu^2) in plane strain.
  // For a crack along an axis of the lattice it is that of Sih, Paris and Irwin (1965) to 1e-3.
  double stiffness() const { return 8.0 * shear / (kappa + 1.0); }
};
PlaneModuli plane_moduli(const Moduli& lattice);

enum class FractureMode { opening, sliding };

// A displacement and its derivative ahead, in the frame of a tip.
struct TipField {
  Vec2 u{0, 0};
  Vec2 ahead{0, 0};
};

// Returns term n of the series, r^(n/2) times a function of the angle, times 2 mu (so without
// moduli but kappa), at `place` in the frame of the tip (Williams 1957; as in Kuna, Finite Elements
// in Fracture Mechanics, 3.2). Term 1 is the singular one: K_I = sqrt(2 pi) A_1 and
// K_II = -sqrt(2 pi) B_1, where A and B are the factors of opening and sliding.
TipField williams_term(int n, FractureMode mode, const Vec2& place, double kappa);

// Returns the field with K_I (or K_II) = 1 Pa sqrt(m).
TipField unit_field(FractureMode mode, const Vec2& place, const PlaneModuli& moduli);

struct WilliamsFit {
  double K_I = 0.0, K_II = 0.0;  // Pa sqrt(m)
  double T = 0.0;                // Pa, stress along the crack
  double misfit = 0.0;           // root of the mean square of what is left, over that of u
};

// Fits terms -1 to 6 and a rigid translation to the displacements of the nodes between two radii,
// m, by least squares. Term -1 takes up that the bonds end the crack not exactly at the tip.
// Nothing with fewer nodes than thrice the unknowns.
std::optional<WilliamsFit> fit_williams(const View& view, const TipFrame& frame, double inner,
                                        double outer, const PlaneModuli& moduli);

}  // namespace hackle
