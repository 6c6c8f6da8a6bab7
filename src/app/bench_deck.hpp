// SPDX-License-Identifier: MIT
// The plate of the benchmark: the paper's first plate, in every way that Hackle can solve it.
#pragma once

#include <array>
#include <string_view>

#include "solver/simulation.hpp"

namespace hackle {

// One way to solve the plate: a row of the benchmark's table.
struct Configuration {
  std::string_view name;
  Precision precision = Precision::f64;
  bool fused = false;
  double alpha = 0.0;     // of the material: with it, s0 depends on the history of stretch
  double fidelity = 0.0;  // see Numerics
  bool threads = false;   // as many as requested; otherwise one
};

inline constexpr std::array configurations{
    Configuration{.name = "f64"},
    Configuration{.name = "f64 fused", .fused = true},
    Configuration{.name = "f64 alpha 0.25", .alpha = 0.25},
    Configuration{.name = "f32", .precision = Precision::f32},
    Configuration{.name = "f32 fused", .precision = Precision::f32, .fused = true},
    Configuration{.name = "f32 alpha 0.25", .precision = Precision::f32, .alpha = 0.25},
    Configuration{.name = "f32 fidelity 0.5", .precision = Precision::f32, .fidelity = 0.5},
    Configuration{.name = "f64 threads", .threads = true},
    Configuration{.name = "f32 threads", .precision = Precision::f32, .threads = true},
};

// 12 MPa on a Duran plate of 100 x 40 mm with an edge crack of 50 mm, as in
// scripts/samples/edge_crack.lua; about `nodes` nodes, m = 4.
struct BenchDeck {
  Plate plate;
  Numerics numerics;
};
BenchDeck bench_deck(const Configuration& configuration, int nodes);

// Returns whether a machine with this instruction set can solve it in this way.
bool is_possible(const Configuration& configuration, InstructionSet set);

// Solves `steps` steps from the start. Returns node-steps per second, without set-up. Throws Error
// (interrupted) on Ctrl-C.
double measure_speed(Simulation& simulation, int steps);

}  // namespace hackle
