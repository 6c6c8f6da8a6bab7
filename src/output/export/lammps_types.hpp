// SPDX-License-Identifier: MIT
// Types of atoms by which LAMMPS knows which nodes no bond joins.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "output/export/lammps_scene.hpp"

namespace hackle {

// LAMMPS bonds all atoms that are near enough, with a horizon per pair of types. So nodes at a cut
// get types such that of two types either all near pairs are bonded or none is. Two lips of a
// straight crack are two types; near its tips nearly every node is one of its own.
struct LammpsTypes {
  std::vector<int> of_node;             // from 1 on
  std::vector<char> strong;             // of type k + 1: its bonds never break
  std::set<std::pair<int, int>> apart;  // pairs of types without bonds, the smaller first
};

// Throws Error (refused) for cuts that need more types than LAMMPS can take.
LammpsTypes lammps_types(const LammpsScene& scene);

}  // namespace hackle
