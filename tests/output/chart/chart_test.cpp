// SPDX-License-Identifier: MIT
#include "output/chart/chart.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "lattice/lattice.hpp"
#include "output/files/record_options.hpp"
#include "output/run/run.hpp"
#include "scene/waves.hpp"
#include "solver/simulation.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const double none = std::numeric_limits<double>::quiet_NaN();

ChartSource energies() {
  return ChartSource(
      SeriesTable{"run",
                  {"time_s", "external_J_per_m", "strain_J_per_m", "damped_J_per_m", "tip_x_m",
                   "tip_speed_m_per_s"},
                  {{0, 1, 2}, {0, 3, 4}, {0, 1, 2}, {0, 0, 0}, {none, 5, 6}, {0, 100, 200}}});
}

std::string refusal(const std::vector<ChartSource>& sources, const std::vector<std::string>& what,
                    const ChartOptions& options = {}) {
  try {
    chart_of(sources, what, options);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
  return "";
}

TEST(ChartOf, AKindDrawsWhatThereIs) {
  const Diagram chart = chart_of({energies()}, {"energy"}, {});
  ASSERT_EQ(chart.curves.size(), 2U);  // what is always 0 says nothing
  EXPECT_EQ(chart.curves[0].name, "external");
  EXPECT_EQ(chart.curves[1].name, "strain");
  EXPECT_THAT(chart.curves[1].points, ElementsAre(Vec2(0, 0), Vec2(1, 1), Vec2(2, 2)));
  EXPECT_EQ(chart.x.unit, "s");
  EXPECT_EQ(chart.y.unit, "J/m");
  EXPECT_EQ(chart.title, "run");
}

TEST(ChartOf, ColumnsAreNamedWithADotOrAsInTheFile) {
  for (const char* name : {"tip.x", "tip_x", "tip_x_m"}) {
    const Diagram chart = chart_of({energies()}, {name}, {});
    ASSERT_EQ(chart.curves.size(), 1U) << name;
    EXPECT_EQ(chart.y.unit, "m");
    EXPECT_TRUE(std::isnan(chart.curves[0].points[0].y()));
    EXPECT_EQ(chart.curves[0].points[2].y(), 6.0);
  }
}

TEST(ChartOf, AnotherXIsTaken) {
  ChartOptions options;
  options.x = "tip.x";
  const Diagram chart = chart_of({energies()}, {"strain"}, options);
  EXPECT_EQ(chart.x.unit, "m");
  EXPECT_EQ(chart.curves[0].points[2], Vec2(6, 2));
}

TEST(ChartOf, SourcesAreToldApart) {
  ChartSource other = energies();
  other.rename("other");
  const Diagram one = chart_of({energies(), other}, {"tip.x"}, {});
  EXPECT_EQ(one.curves[0].name, "run");
  EXPECT_EQ(one.curves[1].name, "other");
  const Diagram two = chart_of({energies(), other}, {"external", "strain"}, {});
  EXPECT_EQ(two.curves[3].name, "other strain");
}

TEST(ChartOf, RefusesWhatCannotBeDrawn) {
  EXPECT_THAT(refusal({energies()}, {"tip.sped"}), HasSubstr("did you mean 'tip_speed'"));
  EXPECT_THAT(refusal({energies()}, {"tip.x", "tip.speed"}), HasSubstr("m/s"));
  EXPECT_THAT(refusal({energies()}, {"load"}), HasSubstr("no forces"));
  EXPECT_THAT(refusal({energies()}, {"histogram"}), HasSubstr("no field"));
  EXPECT_THAT(refusal({energies()}, {"fragments"}), HasSubstr("'fragments'"));
  ChartOptions options;
  options.x = "tme";
  EXPECT_THAT(refusal({energies()}, {"strain"}, options), HasSubstr("'tme'"));
}

// The force on the plate is the opposite of that on the load; the larger one decides.
TEST(ChartOf, LoadIsDrawnAgainstItsWay) {
  const ChartSource source(
      SeriesTable{"run",
                  {"time_s", "grip_fx_N_per_m", "grip_fy_N_per_m", "grip_ux_m", "grip_uy_m"},
                  {{0, 1}, {0, 5}, {0, -200}, {0, 3}, {0, 0.5}}});
  const Diagram chart = chart_of({source}, {"load"}, {});
  ASSERT_EQ(chart.curves.size(), 1U);
  EXPECT_THAT(chart.curves[0].points, ElementsAre(Vec2(0, 0), Vec2(0.5, 200)));
  EXPECT_EQ(chart.y.unit, "N/m");
  EXPECT_EQ(chart.x.unit, "m");
}

class ChartOfRun : public testing::Test {
 protected:
  ChartOfRun() : run(test::edge_crack(14e6), test::numerics(1e-3, 4e-3), {1}, Talk::quiet, {}) {
    RecordOptions options;
    options.every = 2e-6;
    run.record(folder.path / "a.h5", options);
    run.run(14e-6);
    run.close();
  }

  test::Folder folder;
  hackle::Run run;
};

TEST_F(ChartOfRun, RecordsKnowWhatNoTableHas) {
  const ChartSource source(std::make_shared<Recording>(folder.path / "a.h5"));
  const Diagram chart = chart_of({source}, {"bonds"}, {});
  EXPECT_EQ(chart.curves[0].points.size(), 8U);
  const Lattice& lattice = run.simulation().lattice();
  const auto count = [&](const BondBits& bonds) {
    const auto held = degrees(lattice.grid, lattice.family, bonds);
    return std::reduce(held.begin(), held.end(), 0) / 2;
  };
  const int broken = count(lattice.bonds) - count(run.simulation().state().bonds);
  EXPECT_EQ(chart.curves[0].points.back().y(), static_cast<double>(broken));
  EXPECT_GT(broken, 100);
}

TEST_F(ChartOfRun, SpeedStandsAgainstRayleighWaves) {
  const ChartSource source("run", {}, run.simulation().view());
  const Moduli& moduli = run.simulation().lattice().calibration.moduli;
  EXPECT_EQ(source.rayleigh(),
            wave_speeds(moduli.E, moduli.nu, run.simulation().lattice().rho).rayleigh);
  const ChartSource recorded(std::make_shared<Recording>(folder.path / "a.h5"));
  const Diagram chart = chart_of({recorded}, {"speed"}, {});
  ASSERT_EQ(chart.levels.size(), 1U);
  EXPECT_DOUBLE_EQ(chart.levels[0].value, *source.rayleigh());
}

TEST_F(ChartOfRun, AHistogramCountsEveryNode) {
  const ChartSource source("run", {}, run.simulation().view());
  ChartOptions options;
  options.field = "stress_yy";
  options.bins = 7;
  const Diagram chart = chart_of({source}, {"histogram"}, options);
  ASSERT_EQ(chart.curves[0].points.size(), 7U);
  double nodes = 0.0;
  for (const Vec2& bin : chart.curves[0].points) nodes += bin.y();
  EXPECT_EQ(nodes, static_cast<double>(run.simulation().lattice().grid.nodes()));
  EXPECT_EQ(chart.x.unit, "Pa");
}

TEST(CheckChart, RefusesSizesAndRangesThatCannotBe) {
  const auto problem = [](const ChartOptions& options) -> std::string {
    try {
      check("chart", options);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  ChartOptions options;
  EXPECT_EQ(problem(options), "");
  options.y_range = Ends{2.0, 1.0};
  EXPECT_THAT(problem(options), HasSubstr("y_range has no width"));
  options = {};
  options.x_range = Ends{0.0, 1.0};
  options.x_scale = Scale::log;
  EXPECT_THAT(problem(options), HasSubstr("logarithmic"));
  options = {};
  options.paper = 0.02;
  options.dpi = 30.0;
  EXPECT_THAT(problem(options), HasSubstr("px"));
}

TEST(WriteChart, TheTableStandsBesideThePicture) {
  const test::Folder folder;
  EXPECT_EQ(table_of_chart("a/speed.pdf"), "a/speed.chart.csv");
  write_chart(chart_of({energies()}, {"tip.speed"}, {}), {}, folder.path / "sub" / "speed.svg");
  const SeriesTable table = read_series(folder.path / "sub" / "speed.chart.csv");
  EXPECT_EQ(table.headings, (std::vector<std::string>{"time_s", "tip_speed_m_per_s"}));
  EXPECT_EQ(table.columns[1], (std::vector<double>{0, 100, 200}));
}

}  // namespace
}  // namespace hackle
