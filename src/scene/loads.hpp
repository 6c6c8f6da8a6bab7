// SPDX-License-Identifier: MIT
// The loads on a plate. A load is a quantity in space times an amplitude in time; loads may be
// exchanged while a plate is being solved. Each kind has a header with its description in loads/.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/loads/absorber.hpp"
#include "scene/loads/body_force.hpp"
#include "scene/loads/foundation.hpp"
#include "scene/loads/impactor.hpp"
#include "scene/loads/platen.hpp"
#include "scene/loads/pressure.hpp"
#include "scene/loads/roller.hpp"
#include "scene/loads/support.hpp"
#include "scene/loads/thermal_load.hpp"
#include "scene/loads/traction.hpp"

namespace hackle {

struct Loads {
  std::vector<Traction> tractions;
  std::vector<Pressure> pressures;
  std::vector<BodyForce> body_forces;
  std::vector<Support> supports;
  std::vector<ThermalLoad> thermal_loads;
  std::vector<Impactor> impactors;
  std::vector<Foundation> foundations;
  std::vector<Absorber> absorbers;
  std::vector<Roller> rollers;
  std::vector<Platen> platens;
  double damping = 0.0;            // 1/s: every velocity decays as exp(-damping t)
  double stiffness_damping = 0.0;  // s: a bond pulls by this times its rate of stretch more
};

template <>
inline constexpr auto description_of<Loads> = describe_noun(
    "loads", "load", member("tractions", &Loads::tractions), member("pressures", &Loads::pressures),
    member("body_forces", &Loads::body_forces), member("supports", &Loads::supports),
    member("temperatures", &Loads::thermal_loads), member("impactors", &Loads::impactors),
    member("foundations", &Loads::foundations), member("absorbers", &Loads::absorbers),
    member("rollers", &Loads::rollers), member("platens", &Loads::platens),
    member("damping", &Loads::damping,
           {.unit = "1/s",
            .range = at_least(0.0),
            .fallback = "0",
            .sentence = "Velocities decay as exp(-rate t); stable for any rate."}),
    member("stiffness_damping", &Loads::stiffness_damping,
           {.unit = "s",
            .range = at_least(0.0),
            .fallback = "0",
            .sentence = "Rayleigh's beta: bonds resist the rate of their stretch; waves of angular "
                        "frequency w decay as exp(-beta w^2 t/2), rigid motion does not."}));

// Visits all rollers, then all platens.
template <class LoadsOrConst, class Visit>
void for_each_guided(LoadsOrConst& loads, const Visit& visit) {
  for (auto& roller : loads.rollers) visit(roller);
  for (auto& platen : loads.platens) visit(platen);
}

// Returns all loads of one kind.
template <class Load>
std::vector<Load>& all_of(Loads& loads) {
  std::vector<Load>* found = nullptr;
  for_each_member<Loads>([&](const auto& list) {
    using List = std::remove_cvref_t<decltype(loads.*list.pointer)>;
    if constexpr (std::is_same_v<List, std::vector<Load>>) found = &(loads.*list.pointer);
  });
  return *found;
}

// Visits the list of loads of every kind.
template <class Visit>
void for_each_list(const Loads& loads, const Visit& visit) {
  for_each_member<Loads>([&](const auto& list) {
    if constexpr (requires { (loads.*list.pointer).begin(); }) visit(loads.*list.pointer);
  });
}

// Returns the largest stiffness, N/m4, that springs among the loads may add to rho omega^2 of a
// node: those of loads that have a spring_stiffness() of their own.
double spring_stiffness(const Loads& loads);

// Adds a problem for every value out of its range. check(Plate) checks whether rims and regions
// exist.
void check(const Loads& loads, Problems& problems);

// Returns ", 2 tractions, 1 support", or "".
std::string describe(const Loads& loads);

}  // namespace hackle
