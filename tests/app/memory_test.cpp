// SPDX-License-Identifier: MIT
// Compares the memory of a process that solves a large plate, including set-up and summary, with
// the estimate.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "base/files.hpp"
#include "base/machine.hpp"
#include "lattice/needs.hpp"
#include "support/scenes.hpp"
#include "support/skipping.hpp"

namespace hackle {
namespace {

// Returns the peak memory of the process that runs `steps` steps of a script, bytes.
double peak_of(const std::string& script) {
  const test::Folder folder;
  write_text(folder.path / "a.lua", script);
  const test::Ended ended = test::Program(folder).run({"run", "a.lua", "--json", "-q"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  return nlohmann::json::parse(ended.out).at("peak_rss_bytes");
}

std::string scene_of(int size, const std::string& precision, const std::string& more) {
  return fmt::format(
      "local p = plate {{ width = {0}*mm, height = {0}*mm, material = material {{ like = "
      "'duran50', "
      "alphaT = 3e-6 }} }}\n{2}\n"
      "local s = simulate(p, {{ spacing = 1*mm, precision = '{1}' }})\ns:step(2)",
      size, precision, more);
}

struct Large {
  const char* script;
  void (*make)(Plate&);
};

void pull(Plate& plate) {
  plate.loads.tractions.push_back({Edge::top, {0.0, 1e6}, 0.0, {}});
}

TEST(Memory, OfTheProcessIsWithinAThirdOfWhatWasSaid) {
  HACKLE_NEEDS(available_memory() >= std::uint64_t{1} << 30, "less than 1 GB is free");
  constexpr int size = 1200;
  const Large plates[] = {
      {"p:traction { edge = 'top', stress = {0, 1*MPa} }", pull},
      {"p:contact {} p:nofail { edge = 'top', depth = 4*mm } p:strength { modulus = 10 }",
       [](Plate& plate) {
         plate.contact = Contact{};
         plate.scatter = Scatter{.spread = 10.0};
         plate.no_fail.push_back(strip(plate, Edge::top, 4e-3));
       }},
      {"p:body_force { force = {1e5, 0} }",
       [](Plate& plate) {
         plate.loads.body_forces.push_back({{}, Vec2(1e5, 0.0), {}});
       }},
      {"p:initial { velocity = {1, 0} }",
       [](Plate& plate) {
         plate.initial_conditions.push_back({{}, Vec2(0.0, 0.0), Vec2(1.0, 0.0)});
       }},
      {"p:temperature { change = 1, time = ramp(1*us) }",
       [](Plate& plate) {
         plate.loads.thermal_loads.push_back({{}, 1.0, ramp(1e-6)});
       }},
  };
  for (const Precision precision : {Precision::f32, Precision::f64})
    for (const Large& large : plates) {
      const std::string name(name_of(precision));
      Plate plate = test::bare_plate(1, 1);
      plate.width = plate.height = size * 1e-3;
      plate.material.alphaT = 3e-6;
      large.make(plate);
      Numerics numerics = test::numerics(1e-3, 4e-3);
      numerics.precision = precision;
      const double said = memory_of(plate, numerics).all();
      const double taken =
          peak_of(scene_of(size, name, large.script)) - peak_of(scene_of(20, name, large.script));
      RecordProperty(name, std::to_string(taken / said));
      EXPECT_LT(taken, 1.3 * said)
          << name << " " << large.script << ": " << 1e-6 * taken << " MB of " << 1e-6 * said;
      EXPECT_GT(taken, 0.6 * said) << name << " " << large.script;
    }
}

TEST(Memory, OfComingToRestIsWithinAThirdOfWhatWasSaid) {
  constexpr int size = 400;
  const std::string load =
      "p:traction { edge = 'top', stress = {0, 1*MPa} } p:clamp { edge = 'bottom', depth = 4*mm }";
  const auto peak = [&](int nodes) {
    return peak_of(scene_of(nodes, "f64", load) + "\ns:relax { tolerance = 0.1 }");
  };
  Plate plate = test::bare_plate(1, 1);
  plate.width = plate.height = size * 1e-3;
  pull(plate);
  plate.loads.supports.push_back({.region = strip(plate, Edge::bottom, 4e-3)});
  const Memory memory = memory_of(plate, test::numerics(1e-3, 4e-3));
  const double taken = peak(size) - peak(20), said = memory.all() + memory.statics;
  EXPECT_LT(taken, 1.3 * said) << 1e-6 * taken << " MB of " << 1e-6 * said;
  EXPECT_GT(taken, 0.6 * said);
}

}  // namespace
}  // namespace hackle
