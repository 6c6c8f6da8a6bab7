// SPDX-License-Identifier: MIT
// The input deck of a LammpsScene, and the data file with its atoms.
#pragma once

#include <cstdint>
#include <string>

#include "output/export/lammps_scene.hpp"

namespace hackle {

struct LammpsPlan {
  std::int64_t steps = 0;
  std::int64_t every = 0;  // steps between samples in nodes.dump: id, x, y, damage; 0 for none
  // Favours LAMMPS where it is timed: a short list of contacts that is never made again.
  bool is_timed = false;
  std::string heading;  // comment lines, each with its #
};

// Atom n + 1 is node n, in the units of the scene.
std::string lammps_data(const LammpsScene& scene);

// Returns the deck, which reads the atoms from `data_name`. Throws Error (refused) for loads of
// more than 30 sizes or directions: LAMMPS has 32 groups.
std::string lammps_deck(const LammpsScene& scene, const LammpsPlan& plan,
                        const std::string& data_name);

}  // namespace hackle
