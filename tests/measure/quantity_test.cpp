// SPDX-License-Identifier: MIT
#include "measure/quantity.hpp"

#include <regex>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/error.hpp"
#include "measure/scalar.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

Simulation loaded_plate() {
  Plate plate = test::edge_crack(12e6);
  plate.loads.tractions.front().amplitude = ramp(4e-6);
  plate.loads.tractions.front().name = "pull";
  Support support;
  support.region = Region(strip(plate, Edge::right, 2e-3));
  support.kind = Support::Kind::velocity;
  support.name = "grip";
  plate.loads.supports.push_back(support);
  return Simulation(plate, test::numerics(2e-3, 8e-3), {1});
}

std::optional<double> value_of(const std::string& name, const Simulation& simulation) {
  CrackTrack cracks;
  cracks.look(simulation);
  const View view = simulation.view();
  Glance glance(view, cracks, &simulation);
  return column_named(name, view, true, "log").value(glance);
}

std::string refusal_of(const std::string& name, bool of_run) {
  try {
    column_named(name, loaded_plate(), of_run, "log");
  } catch (const Error& error) {
    return fmt::format("{}; {}", error.what(), error.problems().front().remedy);
  }
  return "";
}

TEST(Quantity, AgreesWithWhatElseKnowsIt) {
  Simulation simulation = loaded_plate();
  simulation.run(5e-6);
  const Energy now = energy(simulation);
  EXPECT_EQ(value_of("time", simulation), simulation.time());
  EXPECT_EQ(value_of("step", simulation), static_cast<double>(simulation.state().step));
  EXPECT_EQ(value_of("kinetic", simulation), now.kinetic);
  EXPECT_EQ(value_of("strain", simulation), now.strain);
  EXPECT_EQ(value_of("external", simulation), now.external);
  EXPECT_EQ(value_of("residual", simulation), now.residual());
  EXPECT_EQ(value_of("grip.fx", simulation), simulation.reactions().front().force.x());
  EXPECT_EQ(value_of("pull.factor", simulation), 1.0);
  const auto stress = scalar_of("stress_1").values(simulation);
  EXPECT_EQ(value_of("max.stress_1", simulation), *std::ranges::max_element(stress));
}

TEST(Quantity, AWrongNameIsRefusedWithTheNearest) {
  EXPECT_THAT(refusal_of("externl", true), HasSubstr("did you mean 'external'?"));
  EXPECT_THAT(refusal_of("gripp.fx", true), HasSubstr("did you mean 'grip.fx'?"));
  EXPECT_THAT(refusal_of("max.stres_1", true), HasSubstr("did you mean 'max.stress_1'?"));
  EXPECT_THAT(refusal_of("grip.fx", false), HasSubstr("a recording does not know 'grip.fx'"));
  EXPECT_THAT(refusal_of("external", false), HasSubstr("in s:log"));
}

// pandas, gnuplot and HDF5 take the heading of every column as it is.
TEST(Quantity, EveryHeadingIsAnIdentifierOfItsOwn) {
  std::set<std::string> headings;
  const auto add = [&](std::string name, std::string_view unit) {
    const std::string heading = heading_of({std::move(name), std::string(unit), {}});
    EXPECT_TRUE(std::regex_match(heading, std::regex("[A-Za-z_][A-Za-z0-9_]*"))) << heading;
    EXPECT_TRUE(headings.insert(heading).second) << heading;
  };
  for (const Quantity& one : quantities()) add(std::string(one.name), one.unit);
  for (const PartQuantity& one : load_quantities()) add(fmt::format("grip.{}", one.name), one.unit);
  for (const Scalar& one : scalars()) add(fmt::format("max.{}", one.name), one.unit);
  EXPECT_TRUE(headings.contains("tip_speed_m_per_s"));
}

// At the rate of steps a table looks at no bond but those that break.
TEST(Quantity, UsualColumnsThatAreCheapLeaveOutWhatLooksAtEveryBond) {
  const Simulation simulation = loaded_plate();
  const auto names = [&](bool cheap) {
    std::set<std::string> all;
    for (const Column& one : usual_columns(simulation, true, cheap)) all.insert(one.name);
    return all;
  };
  EXPECT_TRUE(names(false).contains("kinetic"));
  EXPECT_FALSE(names(true).contains("kinetic"));
  EXPECT_FALSE(names(true).contains("external"));  // with supports
  EXPECT_TRUE(names(true).contains("grip.fx"));    // it was given a name
}

}  // namespace
}  // namespace hackle
