// SPDX-License-Identifier: MIT
// What changes while a scene is solved.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "lattice/lattice.hpp"
#include "solver/scratch.hpp"

namespace hackle {

// Displacement and velocity of every node in lattice units, u/dx and v dt/dx, so that u += v needs
// no factor. Places are those of a NodeLayout; ghosts mean nothing.
template <class Real>
struct Motion {
  Values<Real> ux, uy;
  Values<Real> vx, vy;
  Values<Real> threshold;  // e above which the bonds of a node break; only where a history moves it
};

// A rigid disc in flight, in lattice units: its place from the centre of the lattice, and its
// velocity half a step earlier.
struct Disc {
  Vec2 centre{0, 0};
  Vec2 velocity{0, 0};
};

// The time of steps, counted from the last moment that was reached other than by steps.
struct Clock {
  double moment = 0.0;     // s
  std::int64_t since = 0;  // the step at which it was that time

  // In the middle of a step where `share` of one is 0.5, s.
  double time(std::int64_t step, double share, double dt) const {
    return moment + (static_cast<double>(step - since) + share) * dt;
  }
  bool operator==(const Clock&) const = default;
};

// Leapfrog: u belongs to the time of the step, v to half a step earlier; at step `start` both to
// the same time. The bonds are those that hold when the next step begins.
struct State {
  State() = default;
  State(const Lattice& lattice, Precision precision);

  NodeLayout layout;
  std::variant<Motion<double>, Motion<float>> motion;
  BondBits bonds;
  std::int64_t step = 0;  // done so far; slow loading goes on in time without any
  Clock clock;
  std::int64_t start = 0;      // step at which the plate was last set in motion, or brought to rest
  double external_work = 0.0;  // done by loads so far, and by supports and changes of temperature
                               // up to half a step ago, in units of rho dx^4/dt^2 (J/m)
  double damped = 0.0;         // taken by damping up to a step ago, in the same units
  double released = 0.0;       // energy released by jumps and on the way to rest so far, likewise
  double contact_lost = 0.0;   // stored in contacts and gone when bonds broke there, less what is
                               // stored there since the plate came to rest without them, likewise
  Vec2 origin{0, 0};           // a translation of the whole plate that was taken out of u
  std::vector<Disc> discs;     // in the order of the impactors of the plate

  Precision precision() const { return motion.index() == 0 ? Precision::f64 : Precision::f32; }
  bool is_start() const { return step == start; }
  // In lattice units; u without the origin.
  Vec2 u(int i, int j) const;
  Vec2 v(int i, int j) const;
  void set_u(int i, int j, const Vec2& u);
  void set_v(int i, int j, const Vec2& v);

  // Sixteen hexadecimal digits over all of the above, ghosts apart: equal means the same bits.
  std::string hash() const;
};

}  // namespace hackle
