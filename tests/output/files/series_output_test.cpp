// SPDX-License-Identifier: MIT
#include "output/files/series_output.hpp"

#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "output/files/output_mark.hpp"
#include "output/files/record_options.hpp"
#include "output/report/summary.hpp"
#include "output/run/run.hpp"
#include "support/folder.hpp"
#include "support/run_file_reader.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

hackle::Run run_of(const Plate& plate) {
  return hackle::Run(plate, test::numerics(1e-3, 4e-3), {1}, Talk::quiet, {"a.lua", "-- x"});
}

std::vector<Column> named(const hackle::Run& run, const SeriesOptions& options,
                          const std::vector<std::string>& names) {
  std::vector<Column> columns;
  for (const std::string& name : names)
    columns.push_back(column_named(name, run.simulation(), true, "log"));
  return checked_columns(std::move(columns), options, run.simulation(), true, "log");
}

std::vector<double> column(const SeriesTable& table, const std::string& heading) {
  const auto found = std::ranges::find(table.headings, heading);
  if (found == table.headings.end()) return {};
  return table.columns[static_cast<std::size_t>(found - table.headings.begin())];
}

// A plate that flies as one: its displacement is v t at any time, also between steps.
TEST(SeriesOutput, RowsLieAtTheTimesAskedFor) {
  const auto path = test::fresh_folder() / "a.csv";
  Plate plate = test::bare_plate(40, 20);
  plate.initial_conditions.push_back({{}, {}, Vec2(3.0, 0.0)});
  hackle::Run run = run_of(plate);
  SeriesOptions options;
  options.every = 0.47e-6;
  run.log(path, options, named(run, options, {"max.displacement_x"}));
  run.run(2e-6);
  run.close();
  const SeriesTable table = read_series(path);
  EXPECT_EQ(table.headings, (std::vector<std::string>{"time_s", "max_displacement_x_m"}));
  ASSERT_EQ(table.columns[0].size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    const double time = 0.47e-6 * static_cast<double>(k);
    EXPECT_NEAR(table.columns[0][k], time, 1e-18);
    EXPECT_NEAR(table.columns[1][k], 3.0 * time, 1e-7 * 3.0 * 2e-6);  // fields are floats
  }
  EXPECT_THAT(run.summary().files, testing::ElementsAre(path));
}

// Cutting a run into pieces changes no row; every step has one, the first state too.
TEST(SeriesOutput, EveryStepHasARowHoweverTheRunIsCut) {
  const auto folder = test::fresh_folder();
  const auto log_run = [&](const std::string& name, const std::vector<double>& pieces) {
    hackle::Run run = run_of(test::edge_crack(24e6));
    run.log(folder / name, {},
            checked_columns(usual_columns(run.simulation(), true, true), {}, run.simulation(), true,
                            "log"));
    for (const double piece : pieces) run.run(piece);
    run.close();
    return std::pair(read_text(folder / name), run.simulation().state().step);
  };
  const auto [whole, steps] = log_run("whole.csv", {16e-6});
  EXPECT_EQ(log_run("cut.csv", {5.3e-6, 0.1e-6, 10.6e-6}).first, whole);
  const SeriesTable table = read_series(folder / "whole.csv");
  ASSERT_EQ(static_cast<std::int64_t>(table.columns[0].size()), steps + 1);
  EXPECT_EQ(column(table, "step").back(), static_cast<double>(steps));
  EXPECT_GT(column(table, "bonds").back(), 100.0);
  EXPECT_GT(column(table, "external_J_per_m").back(), 0.0);
  EXPECT_TRUE(std::ranges::is_sorted(column(table, "crack_length_m")));
}

// Through the registry of the system: a table of a clamped plate that is pulled slowly.
TEST(SeriesOutput, SlowLoadingHasARowForEachIncrement) {
  const auto path = test::fresh_folder() / "a.csv";
  Plate plate = test::bare_plate(40, 20);
  Support left, right;
  left.region = Region(strip(plate, Edge::left, 2e-3));
  right.region = Region(strip(plate, Edge::right, 2e-3));
  right.value = Vec2(1e-6, 0.0);
  right.amplitude = ramp(1e-3);
  right.name = "grip";
  plate.loads.supports = {left, right};
  hackle::Run run = run_of(plate);
  run.log(path, {}, named(run, {}, {"grip.fx", "grip.ux", "external"}));
  run.load_slowly(1e-3, 4, 1e-6);
  run.close();
  const SeriesTable table = read_series(path);
  ASSERT_EQ(table.columns[0].size(), 5U);
  const std::vector<double> force = column(table, "grip_fx_N_per_m");
  const std::vector<double> way = column(table, "grip_ux_m");
  for (std::size_t k = 1; k < 5; ++k) {
    EXPECT_NEAR(table.columns[0][k], 0.25e-3 * static_cast<double>(k), 1e-12);
    EXPECT_NEAR(way[k], 0.25e-6 * static_cast<double>(k), 1e-15);
    // Linear to the strain, 5e-5, and the plate pulls back on the grip.
    EXPECT_NEAR(force[k] / force[4], 0.25 * static_cast<double>(k), 1e-3);
    EXPECT_LT(force[k], 0.0);
  }
  // What was put in is half the last force times the way.
  EXPECT_NEAR(column(table, "external_J_per_m")[4], -0.5 * force[4] * way[4],
              1e-3 * std::abs(0.5 * force[4] * way[4]));
}

TEST(SeriesOutput, ARunFileGetsACopy) {
  const auto folder = test::fresh_folder();
  hackle::Run run = run_of(test::edge_crack(12e6));
  SeriesOptions options;
  // Between steps a recording knows the velocities of that time, and the ledger those of the step.
  const double dt = run.simulation().dt();
  options.every = dt;
  run.log(folder / "numbers.csv", options, named(run, options, {"kinetic", "bonds"}));
  run.record(folder / "a.h5", {2.0 * dt});
  run.run(4.0 * dt);
  run.close();
  EXPECT_EQ(Recording(folder / "a.h5").times().size(), 3U);
  const SeriesTable table = read_series(folder / "numbers.csv");
  EXPECT_EQ(table.columns[0].size(), 5U);
  {
    const test::RunFileReader reader(folder / "a.h5");
    EXPECT_EQ(reader.numbers("series/numbers/time_s"), table.columns[0]);
    EXPECT_EQ(reader.numbers("series/numbers/kinetic_J_per_m"), table.columns[1]);
    EXPECT_EQ(reader.numbers("series/numbers/bonds"), table.columns[2]);
  }
  Recording recording(folder / "a.h5");
  SeriesOptions all;
  write_table(recording, folder / "again.csv", all,
              checked_columns({column_named("kinetic", recording.view(), false, "log")}, all,
                              recording.view(), false, "log"));
  const SeriesTable again = read_series(folder / "again.csv");
  ASSERT_EQ(again.columns[0].size(), 3U);
  // Velocities of a record are floats.
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(again.columns[1][k], table.columns[1][2 * k], 1e-6 * table.columns[1][4]);
}

// A run that goes on in another program, from a state in the middle: its table is that of a run in
// one piece, also where the first program had gone further than the state that was kept.
TEST(SeriesOutput, GoesOnBehindAMark) {
  const auto folder = test::fresh_folder();
  for (const std::optional<double> every : {std::optional<double>(), std::optional(0.37e-6)}) {
    SeriesOptions options;
    options.every = every;
    const auto output_for = [&](const Simulation& simulation, const char* name) {
      return SeriesOutput(folder / name, options,
                          checked_columns({column_named("bonds", simulation, true, "log"),
                                           column_named("external", simulation, true, "log")},
                                          options, simulation, true, "log"),
                          simulation);
    };
    Simulation whole(test::edge_crack(24e6), test::numerics(1e-3, 4e-3), {1}), first = whole;
    SeriesOutput in_one = output_for(whole, "whole.csv"), cut = output_for(first, "cut.csv");
    Observer *one = &in_one, *other = &cut;
    whole.run(8e-6, {&one, 1});
    in_one.close();
    first.run(4e-6, {&other, 1});
    const OutputMark mark = cut.mark();
    cut.settled()();
    Simulation second = first;
    first.run(1e-6, {&other, 1});
    cut.close();
    SeriesOutput next = output_for(second, "cut.csv");
    next.continue_from(mark);
    other = &next;
    second.run(4e-6, {&other, 1});
    next.close();
    EXPECT_EQ(read_text(folder / "cut.csv"), read_text(folder / "whole.csv"));
  }
}

TEST(SeriesOutput, LogsWhatARunKnowsAndNothingTwice) {
  hackle::Run run = run_of(test::edge_crack(12e6));
  EXPECT_THROW(named(run, {}, {"bonds", "bonds"}), Error);
  SeriesOptions nowhere;
  nowhere.along = Vec2(0.0, 0.0);
  EXPECT_THROW(named(run, nowhere, {"bonds"}), Error);
  EXPECT_EQ(named(run, {}, {"bonds", "time"}).front().name, "time");
  EXPECT_THROW(run.log("a.txt", {}, {}), Error);
}

// A run that waits while another one goes on, whose checkpoint tells of the rows of both.
TEST(SeriesOutput, SettledRowsAreInTheFile) {
  const auto path = test::fresh_folder() / "a.csv";
  hackle::Run run = run_of(test::bare_plate(40, 20));
  SeriesOptions options;
  options.every = 0.5e-6;
  run.log(path, options, named(run, options, {"kinetic"}));
  run.run(3e-6);
  run.settle();
  EXPECT_EQ(static_cast<std::int64_t>(read_series(path).columns[0].size()),
            run.marks().front().pieces);
}

}  // namespace
}  // namespace hackle
