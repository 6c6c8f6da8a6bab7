// SPDX-License-Identifier: MIT
// The variables of a run: everything that changes while a scene is solved.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "lattice/lattice.hpp"
#include "solver/clock.hpp"
#include "solver/values.hpp"

namespace hackle {

// Displacement and velocity of every node in lattice units, u/dx and v dt/dx, so that u += v needs
// no factor. Places are those of a NodeLayout; values of ghosts are meaningless.
template <class Real>
struct Motion {
  Values<Real> ux, uy;
  Values<Real> vx, vy;
  Values<Real> threshold;  // e above which the bonds of a node break; only with a history
};

// Calls visit(name, values) for the arrays of a motion, and of more motions side by side.
template <class Visit, class... Motions>
void for_each_array(const Visit& visit, Motions&... motions) {
  visit("ux", motions.ux...);
  visit("uy", motions.uy...);
  visit("vx", motions.vx...);
  visit("vy", motions.vy...);
  visit("threshold", motions.threshold...);
}

// The place of a rigid body, in lattice units: its centre from the centre of the lattice, and its
// velocity half a step earlier.
struct Disc {
  Vec2 centre{0, 0};
  Vec2 velocity{0, 0};
};

// Leapfrog: u belongs to the time of the step, v to half a step earlier; at step `start` both
// belong to the same time. The bonds are those intact at the beginning of the next step.
struct State {
  State() = default;
  State(const Lattice& lattice, Precision precision);

  NodeLayout layout;
  std::variant<Motion<double>, Motion<float>> motion;
  BondBits bonds;
  std::int64_t step = 0;  // done so far; quasi-static loading advances time without steps
  Clock clock;
  std::int64_t start = 0;      // step at which the plate was last set in motion, or in equilibrium
  double external_work = 0.0;  // by loads so far, and by supports and changes of temperature
                               // up to half a step ago, in units of rho dx^4/dt^2 (J/m)
  double damped = 0.0;         // dissipated by damping up to a step ago, in the same units
  double released = 0.0;       // set free by jumps and on the way to equilibrium so far, likewise
  double contact_lost = 0.0;   // stored in contacts and lost when bonds broke there, minus the part
                               // stored since the plate reached an equilibrium without contacts,
                               // likewise
  Vec2 origin{0, 0};           // a translation of the whole plate, removed from u
  std::vector<Disc> discs;     // in the order of the impactors of the plate
  std::vector<Disc> rollers;   // likewise
  std::vector<Disc> platens;

  Precision precision() const { return motion.index() == 0 ? Precision::f64 : Precision::f32; }
  bool is_start() const { return step == start; }
  // Returns u in lattice units, without the origin.
  Vec2 u(int i, int j) const;
  Vec2 v(int i, int j) const;
  void set_u(int i, int j, const Vec2& u);
  void set_v(int i, int j, const Vec2& v);

  // Returns sixteen hexadecimal digits over all of the above, except ghosts: equal means the same
  // bits.
  std::string hash() const;
  // Of all that grows with the plate.
  std::size_t bytes() const;
  // The same state in f64.
  State in_f64() const;
};

// Returns whether it can be a state of this lattice: its arrays have the size of the layout, and no
// bond holds that the lattice does not have.
bool fits(const State& state, const Lattice& lattice);

// The list of members, which hash, size and conversion follow: calls visit(name, member, matters)
// for each in the order of the hash, the arrays of the motion one by one. The layout is that of the
// lattice. What does not matter has the value that it has in a plain run, and leaves its hash
// alone.
template <class StateOrConst, class Visit>
void for_each_member(StateOrConst& state, const Visit& visit) {
  auto& [layout, motion, bonds, step, clock, start, external_work, damped, released, contact_lost,
         origin, discs, rollers, platens] =
      state;  // a new member breaks the build until it is visited
  std::visit(
      [&visit](auto& arrays) {
        for_each_array([&visit](const char* name, auto& values) { visit(name, values, true); },
                       arrays);
      },
      motion);
  visit("bonds", bonds, true);
  visit("step", step, true);
  visit("external_work", external_work, true);
  visit("start", start, start != 0 && state.is_start());  // then it changes what comes
  visit("clock", clock, clock != Clock{});
  visit("damped", damped, damped != 0.0);
  visit("released", released, released != 0.0);
  visit("contact_lost", contact_lost, contact_lost != 0.0);
  visit("origin", origin, true);
  visit("discs", discs, true);
  visit("rollers", rollers, true);
  visit("platens", platens, true);
}

}  // namespace hackle
