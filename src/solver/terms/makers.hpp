// SPDX-License-Identifier: MIT
// The list of all terms.
#pragma once

#include <array>
#include <memory>

#include "solver/terms/term.hpp"

namespace hackle {

// Makes a term of a plate for steps of dt seconds, or nullptr where the plate does not need it.
// Throws what functions of place throw, and Error (refused) for a load that finds no node and for
// discs too small or too light for the spacing.
using MakeTerm = std::unique_ptr<Term>(const Plate& plate, const Lattice& lattice, double dt);

MakeTerm make_damping, make_forces, make_foundation, make_absorbing_edges, make_stiffness_damping,
    make_impact, make_guided_bodies, make_supports, make_heat, make_contact;

// In the order in which terms act: forces are summed, and work is booked in it. Supports book what
// the forces before them did not; contact feels the heat of the same step.
inline constexpr std::array term_makers = std::to_array<MakeTerm*>(
    {make_damping, make_forces, make_foundation, make_absorbing_edges, make_stiffness_damping,
     make_impact, make_guided_bodies, make_supports, make_heat, make_contact});

}  // namespace hackle
