// SPDX-License-Identifier: MIT
// Handles displacements that have grown too large for single precision. The physics depends on
// differences of neighbours, but f32 rounds u to 6e-8 of its size: a plate that has drifted by two
// spacings gains energy (src/solver/README.md 5.2).
#pragma once

#include <cstdint>
#include <vector>

#include "solver/slab.hpp"
#include "solver/state.hpp"

namespace hackle {

// Half the sum and half the difference of the largest and smallest u of all nodes, per component.
// `material` is Lattice::material: void nodes, which never move, are left out.
struct Spread {
  Vec2 middle{0, 0};
  Vec2 half{0, 0};
};

Spread spread_of(const State& state, const std::vector<std::uint8_t>& material = {});
// The same where each rank knows its own rows; all of them ask.
Spread spread_of(const State& state, const std::vector<std::uint8_t>& material, const Slab& slab);

// Drift of the whole plate, in spacings, above which it is moved from u to the origin.
inline constexpr double max_drift = 0.03125;

// Moves the mid-range displacement of an f32 state to its origin if the state has drifted. For a
// symmetric scene it is exactly 0 across the midline, so symmetry is kept. Returns whether u has
// changed.
bool take_out_drift(State& state, const std::vector<std::uint8_t>& material = {});

// The share of the critical stretch that rounding may reach before the run changes to f64: far
// below the errors of step and spacing, yet the arms of an opened plate stay in f32
// (src/solver/README.md 5.3).
inline constexpr double max_rounding = 2e-4;

// Returns whether a state that is spread like this has drifted, or is too wide, by the limits
// above.
bool is_to_be_moved(const Spread& spread, double s0);

// Returns whether the rest rounds the stretch of bonds by more than max_rounding of s0.
bool is_too_wide_for_f32(const State& state, double s0,
                         const std::vector<std::uint8_t>& material = {});

}  // namespace hackle
