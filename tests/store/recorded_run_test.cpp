// SPDX-License-Identifier: MIT
// Simulations that go on from records.
#include "store/recorded_run.hpp"

#include <functional>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "solver/simulation.hpp"
#include "store/recording.hpp"
#include "store/run_file.hpp"
#include "support/composite.hpp"
#include "support/folder.hpp"
#include "support/run_file_reader.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

RecordContents exact_contents(const Simulation& simulation) {
  RecordContents contents = standard_contents(simulation.lattice().grid);
  contents.exact = true;
  return contents;
}

std::string file_refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// Everything that a state can hold: history, heat, two materials, bodies, damping, contact.
Simulation rich_simulation(Precision precision) {
  Plate plate = test::composite(40, 30, {.mixed = true, .heated = true, .alpha = 0.2});
  plate.loads.thermal_loads.erase(plate.loads.thermal_loads.begin());  // a function of place
  plate.loads.tractions.push_back({Edge::top, {1e6, 20e6}});
  plate.loads.impactors.push_back({{-4e-3, 0.007}, 3.7e-3, {60.0, 5.0}, 0.5});
  plate.loads.damping = 1e4;
  plate.contact = Contact{};
  plate.cracks.push_back({{{0.0, 0.005}, {0.004, 0.006}, {0.006, 0.005}}, Born::absent});
  Numerics numerics = test::numerics(0.5e-3, 1.5e-3);
  numerics.precision = precision;
  return Simulation(plate, numerics, {1});
}

class ExactRecord : public testing::TestWithParam<Precision> {};

TEST_P(ExactRecord, GoesOnWithTheSameBits) {
  const test::Folder folder;
  const auto path = folder.path / "a.h5";
  Simulation simulation = rich_simulation(GetParam());
  {
    RunFile file(path, simulation, {}, exact_contents(simulation));
    for (int k = 0; k < 3; ++k) {
      file.add(simulation);
      simulation.run(1.03e-6);
    }
    file.finish();
  }
  const RecordedRun run(path);
  ASSERT_EQ(run.times().size(), 3U);
  for (std::size_t record = 0; record < 3; ++record) {
    Simulation again = run.simulation_at(record, {2});
    EXPECT_EQ(again.state().hash(), run.hash_of(record));
    while (again.state().step < simulation.state().step) again.step();
    EXPECT_EQ(again.state().hash(), simulation.state().hash()) << record;
  }
  EXPECT_NO_THROW(Recording{path});
}

INSTANTIATE_TEST_SUITE_P(Both, ExactRecord, testing::Values(Precision::f64, Precision::f32));

TEST(RecordedRunFile, OnlyItsFirstRecordIsExactByItself) {
  const test::Folder folder;
  const auto path = folder.path / "a.h5";
  Simulation simulation = rich_simulation(Precision::f64);
  RunFile file(path, simulation, {});
  file.add(simulation);
  simulation.run(1e-6);
  file.add(simulation);
  file.finish();
  const RecordedRun run(path);
  EXPECT_TRUE(run.is_exact(0));
  EXPECT_FALSE(run.is_exact(1));
  EXPECT_THAT(file_refusal([&] { run.simulation_at(1, {1}); }), HasSubstr("exact = true"));
  EXPECT_FALSE(test::RunFileReader(path).holds("records/0/00001/ux"));
}

TEST(RecordedRunFile, ARecordingNeedsBondsAndTheMotionOfAllNodes) {
  const test::Folder folder;
  const auto path = folder.path / "a.h5";
  Simulation simulation = rich_simulation(Precision::f64);
  RecordContents some = standard_contents(simulation.lattice().grid);
  some.fields = {"damage", "stress_1", "velocity"};
  {
    RunFile file(path, simulation, {}, some);
    file.add(simulation);
    file.finish();
  }
  EXPECT_THAT(file_refusal([&] { Recording{path}; }), HasSubstr("without displacement, bonds"));
  const test::RunFileReader reader(path);
  EXPECT_FALSE(reader.holds("records/0/00000/displacement"));
  EXPECT_EQ(reader.shape("records/0/00000/stress_1"), (std::vector<hsize_t>{1200}));
  some = standard_contents(simulation.lattice().grid);
  some.nodes = {1, 2, 10, 9, 3};
  some.part = true;
  some.fields = {"damage", "displacement"};
  {
    RunFile file(path, simulation, {}, some);
    file.add(simulation);
    file.finish();
  }
  EXPECT_THAT(file_refusal([&] { Recording{path}; }), HasSubstr("only a part of the nodes"));
  const test::RunFileReader part(path);
  EXPECT_EQ(part.shape("records/0/00000/displacement"), (std::vector<hsize_t>{90, 3}));
  EXPECT_DOUBLE_EQ(part.numbers("nodes")[3], simulation.lattice().grid.position(4, 2).x());
}

TEST(RecordedRunFile, ExactFieldsAreInDoublePrecision) {
  const test::Folder folder;
  const auto path = folder.path / "a.h5";
  Simulation simulation = rich_simulation(Precision::f64);
  simulation.run(1e-6);
  {
    RunFile file(path, simulation, {}, exact_contents(simulation));
    file.add(simulation);
    file.finish();
  }
  const std::vector<double> u = test::RunFileReader(path).numbers("records/0/00000/displacement");
  EXPECT_EQ(u[3 * 77 + 1], simulation.displacement(77 % 40, 77 / 40).y());
  EXPECT_NE(u[3 * 77 + 1], static_cast<float>(u[3 * 77 + 1]));
}

}  // namespace
}  // namespace hackle
