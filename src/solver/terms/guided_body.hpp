// SPDX-License-Identifier: MIT
// A roller or platen on a lattice: where the machine leads it, and what it touches. Lengths are in
// dx from the centre of the lattice, forces in rho dx^3/dt^2.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/plate.hpp"
#include "solver/state.hpp"
#include "solver/tabulated_amplitude.hpp"
#include "solver/terms/roughness.hpp"

namespace hackle {

struct GuidedBody {
  std::string_view who;  // "roller"
  std::string name;      // as given; may be empty
  Guide guide;
  Vec2 start{0, 0};     // centre before it moves
  double radius = 0.0;  // of a disc; 0 for a box
  Vec2 half{0, 0};      // half the size
  double breadth;       // largest width of what it may press
  double mass;          // in nodes of the plate's own material
  Vec2 value;           // dx, dx per s, or a force, at amplitude 1
  TabulatedAmplitude amplitude;
  Roughness roughness;

  // Returns the overlap with the cell of a node, as a vector out of the body; 0 for none.
  Vec2 overlap(const Vec2& node, const Vec2& centre, double more = 0.0) const;

  // A body led by a force goes along it; its place belongs to the state. That of others is a
  // function of time.
  bool is_pressed() const { return guide == Guide::force; }
  Vec2 along() const { return value.normalized(); }
  Vec2 force(const Clock& clock, std::int64_t step, double dt) const;
  Vec2 centre(const Clock& clock, std::int64_t step, double dt) const;
  // Returns where it starts: half a kick behind, as all velocities are.
  Disc start_of(const Clock& clock, std::int64_t step, double dt) const;

  // Asks functions of time beforehand. Throws what they throw, and Error (refused) where a body
  // crosses more than max_crossed of a spacing in a step.
  void tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double dt);
};

// Returns all rollers, then all platens. Throws Error (refused) for bodies that are too small or
// too light for the spacing, overlap the plate before they move, or have a velocity that is a
// function.
std::vector<GuidedBody> guided_bodies(const Plate& plate, const Lattice& lattice, double dt);

}  // namespace hackle
