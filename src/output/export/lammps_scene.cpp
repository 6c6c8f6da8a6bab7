// SPDX-License-Identifier: MIT
#include "output/export/lammps_scene.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "lattice/lattice.hpp"
#include "lattice/load_map.hpp"

namespace hackle {
namespace {

// Collects what stands in the way, with the name of each.
class Objections {
 public:
  void add_if(bool stands_in_the_way, std::string_view what, std::string_view remedy = {}) {
    if (stands_in_the_way)
      problems_.add(fmt::format("export: LAMMPS's peri/pmb has no {}", what), std::string(remedy));
  }
  void throw_if_any() const { problems_.throw_if_any(); }

 private:
  Problems problems_;
};

template <class Load>
bool varies(const std::vector<Load>& loads) {
  return std::ranges::any_of(loads, [](const Load& load) { return !load.amplitude.is_constant(); });
}

void object_to_loads(const Loads& loads, Objections& objections) {
  objections.add_if(!loads.supports.empty(), "supports that prescribe a motion",
                    "loads by tractions can be exported");
  objections.add_if(!loads.thermal_loads.empty(), "temperature");
  objections.add_if(!loads.impactors.empty(), "impactors");
  objections.add_if(!loads.rollers.empty(), "rollers");
  objections.add_if(!loads.platens.empty(), "platens");
  objections.add_if(!loads.foundations.empty(), "foundations");
  objections.add_if(!loads.absorbers.empty(), "absorbing edges");
  objections.add_if(loads.damping > 0.0 || loads.stiffness_damping > 0.0, "damping of this kind");
  const bool is_course =
      varies(loads.tractions) || varies(loads.pressures) || varies(loads.body_forces);
  objections.add_if(is_course, "loads with an amplitude", "constant loads can be exported");
  const bool is_function =
      std::ranges::any_of(loads.tractions,
                          [](const Traction& load) { return !load.stress.is_constant(); }) ||
      std::ranges::any_of(loads.body_forces,
                          [](const BodyForce& load) { return !load.force.is_constant(); });
  objections.add_if(is_function, "loads that are functions");
}

void object(const Plate& plate, const Numerics& numerics) {
  Objections objections;
  objections.add_if(!plate.inclusions.empty(),
                    "several materials in one plate as Hackle joins them",
                    "plates of one material can be exported");
  objections.add_if(plate.scatter.has_value(), "scattered strength");
  objections.add_if(plate.contact.has_value(), "contact as Hackle has it",
                    "export the plate without contact");
  objections.add_if(!plate.initial_conditions.empty(), "initial motion");
  objections.add_if(
      numerics.quadrature == Quadrature::area || numerics.quadrature == Quadrature::centroid,
      fmt::format("quadrature \"{}\"", name_of(numerics.quadrature)),
      "full and ramp can be exported");
  objections.add_if(numerics.micromodulus == Micromodulus::conical, "conical micromodulus");
  objections.add_if(numerics.surface != Surface::none, "corrected surfaces");
  object_to_loads(plate.loads, objections);
  objections.throw_if_any();
}

void note_differences(const Plate& plate, const Numerics& numerics,
                      std::vector<std::string>& notes) {
  if (numerics.breaking == Breaking::at_once)
    notes.emplace_back(
        "in LAMMPS a bond pulls on in the step that finds it too long: solve with breaking = "
        "\"next_step\" to get the same bonds");
  if (numerics.precision == Precision::f32 || numerics.fused || numerics.fidelity > 0.0)
    notes.emplace_back("LAMMPS computes in double precision, without fused or linearised forces");
  if (numerics.quadrature == Quadrature::ramp)
    notes.emplace_back("LAMMPS adds contact forces to quadrature \"ramp\"");
  if (!plate.no_fail.empty())
    notes.emplace_back("LAMMPS knows strength per node: no-fail zones are a horizon wider there");
}

// Returns, per node, whether it is in a zone: then none of its bonds can break.
std::vector<char> strong_nodes(const Lattice& lattice) {
  if (lattice.unbreakable.empty()) return {};
  const std::vector<std::uint16_t> all = degrees(lattice.grid, lattice.family, lattice.bonds);
  const std::vector<std::uint16_t> strong =
      degrees(lattice.grid, lattice.family, lattice.unbreakable);
  std::vector<char> nodes;
  for (std::size_t node = 0; node < all.size(); ++node)
    nodes.push_back(all[node] > 0 && strong[node] >= all[node] ? 1 : 0);
  return nodes;
}

std::vector<Vec2> pulls(const Plate& plate, const Lattice& lattice, double dt) {
  std::vector<Vec2> pull;
  for (const SpreadForce& force : spread_forces(plate, lattice)) {
    pull.resize(lattice.grid.nodes(), Vec2(0.0, 0.0));
    for (const LoadedNode& node : force.nodes)
      pull[lattice.grid.index(node.i, node.j)] += dt * dt / lattice.grid.dx * node.acceleration;
  }
  return pull;
}

std::vector<std::pair<std::size_t, std::size_t>> cuts_of(const Lattice& lattice) {
  std::vector<std::pair<std::size_t, std::size_t>> cuts;
  const Grid& grid = lattice.grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
        if (!grid.contains(i + a, j + b) || lattice.is_void(i, j) || lattice.is_void(i + a, j + b))
          return;
        if (!lattice.bonds.holds(grid.layout().at(i, j), bit))
          cuts.emplace_back(grid.index(i, j), grid.index(i + a, j + b));
      });
  return cuts;
}

}  // namespace

LammpsScene lammps_scene(const Plate& plate, const Numerics& numerics, double dt,
                         std::vector<std::string>& notes) {
  object(plate, numerics);
  const Lattice lattice(plate, numerics);
  LammpsScene scene;
  scene.grid = lattice.grid;
  for (int j = 0; j < scene.grid.ny; ++j)
    for (int i = 0; i < scene.grid.nx; ++i) scene.removed.push_back(lattice.is_void(i, j) ? 1 : 0);
  scene.m = lattice.family.m();
  if (std::abs(scene.m - std::round(scene.m)) < 1e-9) scene.m = std::round(scene.m);  // as Family
  scene.is_ramped = numerics.quadrature == Quadrature::ramp;
  scene.c = lattice.calibration.c * lattice.grid.dx * dt * dt / lattice.rho;
  scene.s00 = lattice.calibration.s0;
  scene.alpha = plate.material.alpha;
  scene.pull = pulls(plate, lattice, dt);
  scene.strong = strong_nodes(lattice);
  scene.cuts = cuts_of(lattice);
  note_differences(plate, numerics, notes);
  return scene;
}

}  // namespace hackle
