// SPDX-License-Identifier: MIT
// The memory estimate of a scene, made before anything is allocated, must equal the memory that its
// simulation holds.
#include <functional>

#include <gtest/gtest.h>

#include "lattice/needs.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

struct Scene {
  const char* name;
  std::function<void(Plate&, Numerics&)> make;
};

Shape patch(const Plate& plate, double share) {
  return rectangle({0.2 * plate.width, 0.3 * plate.height},
                   {share * plate.width, share * plate.height});
}

void include(Plate& plate, const std::function<void(Material&)>& change) {
  Material other = plate.material;
  change(other);
  plate.inclusions.push_back({patch(plate, 0.7), other});
}

void heat(Plate& plate, Region region) {
  plate.material.alphaT = 9e-6;
  plate.loads.thermal_loads.push_back({std::move(region), 20.0, {}});
}

void cut_out(Plate& plate) {
  plate.cutouts.push_back(
      {Ellipse{{0.5 * plate.width, 0.5 * plate.height}, Vec2::Constant(0.1 * plate.width)}, ""});
}

const std::vector<Scene> scenes{
    {"plain", [](Plate&, Numerics&) {}},
    {"two loads",
     [](Plate& p, Numerics&) {
       p.loads.tractions.push_back({Edge::top, {0.0, 1e6}});
       p.loads.supports.push_back({strip(p, Edge::bottom, 1e-3)});
     }},
    {"m 2", [](Plate&, Numerics& n) { n.horizon = 2.0 * n.spacing; }},
    {"m 3", [](Plate&, Numerics& n) { n.horizon = 3.0 * n.spacing; }},
    {"m 9", [](Plate&, Numerics& n) { n.horizon = 9.0 * n.spacing; }},
    {"m 16", [](Plate&, Numerics& n) { n.horizon = 16.0 * n.spacing; }},
    {"area", [](Plate&, Numerics& n) { n.quadrature = Quadrature::area; }},
    {"conical", [](Plate&, Numerics& n) { n.micromodulus = Micromodulus::conical; }},
    {"surface", [](Plate&, Numerics& n) { n.surface = Surface::energy; }},
    {"fidelity", [](Plate&, Numerics& n) { n.fidelity = 0.1; }},
    {"no-fail", [](Plate& p, Numerics&) { p.no_fail.push_back(patch(p, 0.8)); }},
    {"history", [](Plate& p, Numerics&) { p.material.alpha = 0.25; }},
    {"scatter", [](Plate& p, Numerics&) { p.scatter = Scatter{.spread = 10.0}; }},
    {"scatter and history",
     [](Plate& p, Numerics&) {
       p.scatter = Scatter{.spread = 10.0};
       p.material.alpha = 0.25;
     }},
    {"hole", [](Plate& p, Numerics&) { cut_out(p); }},
    {"crack",
     [](Plate& p, Numerics&) {
       p.cracks.push_back(Crack({0.0, 1e-3}, {3e-3, 1e-3}, Born::absent));
     }},
    {"contact", [](Plate& p, Numerics&) { p.contact = Contact{}; }},
    {"damping", [](Plate& p, Numerics&) { p.loads.damping = 1e4; }},
    {"impact",
     [](Plate& p, Numerics&) {
       p.loads.impactors.push_back({{-5e-3, 2e-3}, 2e-3, {10.0, 0.0}, 1.0});
     }},
    {"inclusion of the same", [](Plate& p, Numerics&) { include(p, [](Material&) {}); }},
    {"inclusion that expands otherwise",
     [](Plate& p, Numerics&) { include(p, [](Material& m) { m.alphaT = 1e-5; }); }},
    {"inclusion of another nu",
     [](Plate& p, Numerics&) { include(p, [](Material& m) { m.nu = 0.3; }); }},
    {"stiffer inclusion", [](Plate& p, Numerics&) { include(p, [](Material& m) { m.E *= 2.0; }); }},
    {"inclusion with a history",
     [](Plate& p, Numerics&) { include(p, [](Material& m) { m.alpha = 0.3; }); }},
    {"heat", [](Plate& p, Numerics&) { heat(p, {}); }},
    {"heat of a disc",
     [](Plate& p, Numerics&) {
       heat(p, Shape{Ellipse{{1e-3, 2e-3}, {2e-3, 1e-3}}});
     }},
    {"two heats, a hole and an inclusion",
     [](Plate& p, Numerics&) {
       heat(p, {});
       heat(p, patch(p, 0.9));
       cut_out(p);
       include(p, [](Material& m) { m.rho *= 0.5, m.alphaT = 0.0; });
     }},
    {"start",
     [](Plate& p, Numerics&) {
       p.initial_conditions.push_back({patch(p, 0.9), Vec2(0.0, 0.0), Vec2(1.0, 0.0)});
     }},
    {"all at once",
     [](Plate& p, Numerics&) {
       heat(p, patch(p, 0.6));
       cut_out(p);
       include(p, [](Material& m) { m.E *= 0.5, m.alpha = 0.1; });
       p.scatter = Scatter{.spread = 10.0};
       p.no_fail.push_back(patch(p, 0.5));
       p.contact = Contact{};
       p.loads.damping = 1e4;
     }},
};

TEST(Memory, IsWhatWasSaid) {
  for (const Scene& scene : scenes)
    for (const Precision precision : {Precision::f64, Precision::f32})
      for (const auto& [nx, ny] : {std::pair{40, 33}, {67, 48}, {16, 7}}) {
        Plate plate = test::bare_plate(nx, ny);
        Numerics numerics = test::numerics();
        numerics.precision = precision;
        scene.make(plate, numerics);
        const Simulation simulation(plate, numerics, {1});
        EXPECT_EQ(static_cast<double>(simulation.bytes()),
                  memory_of(simulation.plate(), numerics).kept)
            << scene.name << ", " << nx << " x " << ny;
      }
}

}  // namespace
}  // namespace hackle
