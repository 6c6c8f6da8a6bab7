// SPDX-License-Identifier: MIT
// The numerical choices of a user: how finely and by what method a scene is solved.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/described.hpp"
#include "base/error.hpp"
#include "scene/plate.hpp"

namespace hackle {

// The weight of a node near the rim of the horizon (src/lattice/README.md 2.1).
enum class Quadrature {
  full,      // 1 for every node within the horizon (FA)
  ramp,      // LAMMPS: 1 up to horizon - dx/2, then linear down to 1/2 at the horizon
  area,      // the part of the node's cell that lies inside the horizon (PA-AC)
  centroid,  // the same, with the bond ending at the centroid of that part (IPA-AC)
};

// The micromodulus as a function of the bond length r.
enum class Micromodulus {
  constant,  // c
  conical,   // c (1 - r/delta)
};

// The source of micromodulus and critical stretch.
enum class Constants {
  lattice,    // such that E and G0 are exact on this lattice
  continuum,  // of an infinitely fine lattice (src/lattice/README.md 3.3): c = 9 E/(pi delta^3) and
              // s0 = sqrt(4 pi G0/(9 E delta)) in plane stress with a constant micromodulus
  paper,      // the paper's Eq. 8 and Eq. 10, which are inconsistent (src/lattice/README.md 3.7)
};

// The correction of nodes that lack bonds: along edges, cut-outs, and cracks that the scene begins
// with (src/lattice/README.md 3.9).
enum class Surface {
  none,
  volume,  // as much stiffer as the weights of their bonds are fewer
  energy,  // as much stiffer as they keep less energy when they are strained along the surface
};

// The step in which an overstretched bond stops pulling.
enum class Breaking {
  at_once,    // the step that finds it
  next_step,  // the next step, as in LAMMPS: longer steps then make a tougher material
};

enum class Precision { f64, f32 };

template <>
inline constexpr auto enum_names<Quadrature> =
    std::to_array<std::string_view>({"full", "ramp", "area", "centroid"});
template <>
inline constexpr auto enum_names<Micromodulus> = std::to_array<std::string_view>({"constant",
                                                                                  "conical"});
template <>
inline constexpr auto enum_names<Constants> =
    std::to_array<std::string_view>({"lattice", "continuum", "paper"});
template <>
inline constexpr auto enum_names<Surface> = std::to_array<std::string_view>({"none", "volume",
                                                                             "energy"});
template <>
inline constexpr auto enum_names<Breaking> = std::to_array<std::string_view>({"at_once",
                                                                              "next_step"});
template <>
inline constexpr auto enum_names<Precision> = std::to_array<std::string_view>({"f64", "f32"});

// The default step as a share of the limit 2/omega_max. The margin covers the stiffening of bonds
// stretched up to s0.
inline constexpr double step_fraction = 0.9;

struct Numerics {
  double spacing = 0.0;  // dx, m
  double horizon = 0.0;  // delta, m; 0: four spacings
  Quadrature quadrature = Quadrature::full;
  Micromodulus micromodulus = Micromodulus::constant;
  Constants constants = Constants::lattice;
  Surface surface = Surface::none;
  Breaking breaking = Breaking::at_once;
  Precision precision = Precision::f64;
  bool fused = false;  // multiply and add with one rounding: faster, but not on every machine
  // Share of the critical stretch below which forces may be linearised, 0..1. Forces are never
  // linearised where materials differ or the temperature changes.
  double fidelity = 0.0;
  double safety = step_fraction;  // the default step over the stability limit, above 0 up to 1
  std::optional<double> step;     // s; if empty, `safety` times the stability limit
  bool force_step = false;        // accept a step above the limit

  double horizon_or_default() const { return horizon != 0.0 ? horizon : 4.0 * spacing; }
  double m() const { return horizon_or_default() / spacing; }  // delta/dx
};

template <>
inline constexpr auto description_of<Numerics> = describe_noun(
    "numerics", "numerics",
    member("spacing", &Numerics::spacing,
           {.unit = "m",
            .range = above(0.0),
            .required = true,
            .sentence = "Distance between neighbouring nodes, dx."}),
    member("horizon", &Numerics::horizon,
           {.unit = "m",
            .range = above(0.0),
            .fallback = "4 spacings",
            .sentence =
                "Horizon of the bonds, delta: 2 to 16 spacings. Without a crack, strength goes "
                "with 1/sqrt(horizon)."}),
    member("precision", &Numerics::precision,
           {.fallback = "f64", .sentence = "Floating-point precision of the computation."}),
    member("fused", &Numerics::fused,
           {.fallback = "false",
            .sentence =
                "Fused multiply-add, one rounding: faster, but not available on every machine."}),
    member("fidelity", &Numerics::fidelity,
           {.range = between(0.0, 1.0),
            .fallback = "0",
            .sentence = "Share of the critical stretch below which forces may be linearised."}),
    member("breaking", &Numerics::breaking,
           {.fallback = "at_once",
            .sentence = "When an overstretched bond stops pulling; LAMMPS uses next_step."}),
    member(
        "quadrature", &Numerics::quadrature,
        {.fallback = "full",
         .sentence = "Weights of nodes near the rim of the horizon; area is the most isotropic."}),
    member("micromodulus", &Numerics::micromodulus,
           {.fallback = "constant", .sentence = "How bond stiffness depends on bond length."}),
    member("constants", &Numerics::constants,
           {.fallback = "lattice", .sentence = "Source of the stiffness and strength of a bond."}),
    member("surface", &Numerics::surface,
           {.fallback = "none",
            .sentence = "Stiffens the soft layer along edges, cut-outs and cracks of the scene; "
                        "energy is the exact one for thin parts."}),
    member("step", &Numerics::step,
           {.unit = "s",
            .range = above(0.0),
            .fallback =
                "safety times the stability limit, or the time in which an impactor crosses 0.1 "
                "spacings",
            .nothing = "default",
            .sentence = "The time step."}),
    member("safety", &Numerics::safety,
           {.range = above_up_to(0.0, 1.0),
            .fallback = "0.9",
            .sentence = "Share of the stability limit that the default time step takes."}),
    member("force_step", &Numerics::force_step,
           {.fallback = "false",
            .sentence = "Accepts a step above the stability limit, to see the run diverge."}));

// The range of m. With m <= 16 every quadrature stays within one NodeLayout group (16 columns).
inline constexpr double min_m = 2.0;
inline constexpr double max_m = 16.0;

}  // namespace hackle
