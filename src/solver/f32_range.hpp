// SPDX-License-Identifier: MIT
// Displacements that have grown too large for single precision. Differences of neighbours are what
// counts, and f32 rounds u to 6e-8 of its size: a plate that has drifted by two spacings gains
// energy (src/solver/README.md 5.2).
#pragma once

#include <cstdint>
#include <vector>

#include "solver/state.hpp"

namespace hackle {

// Half the sum and half the difference of the largest and least u of all nodes, per component.
// `material` is Lattice::material: void nodes, which nothing moves, are left out.
struct Spread {
  Vec2 middle{0, 0};
  Vec2 half{0, 0};
};

Spread spread_of(const State& state, const std::vector<std::uint8_t>& material = {});

// Drift of the whole plate, in spacings, beyond which it is moved from u into the origin.
inline constexpr double max_drift = 0.03125;

// Moves the middle of a state in f32 into its origin when it has drifted. The middle of a scene
// that is symmetric is exactly 0 across the midline, so symmetry is kept. True when u has changed.
bool take_out_drift(State& state, const std::vector<std::uint8_t>& material = {});

// The share of the critical stretch that rounding may reach before f32 is given up: far below the
// errors of step and spacing, yet the arms of a plate that has opened stay in f32
// (src/solver/README.md 5.3).
inline constexpr double max_rounding = 2e-4;

// Whether what remains rounds the stretch of bonds by more than max_rounding of s0.
bool is_too_wide_for_f32(const State& state, double s0,
                         const std::vector<std::uint8_t>& material = {});

}  // namespace hackle
