// SPDX-License-Identifier: MIT
// s:log, r:log and s:reaction.
#include <cstdlib>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "console/scripts.hpp"
#include "store/series_file.hpp"
#include "support/skipping.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

TEST(SeriesBinding, WritesNamesAndFunctionsOfTheSimulation) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(test::scene + R"(
    s:log { "run.csv", every = 1*us, "external", function(s) return s.steps end,
            { twice = function(s) return 2*s.time end, also = function() return 7 end } }
    s:run(2*us) s:close()
  )",
                             test::quiet(folder.path)),
            "");
  const SeriesTable table = read_series(folder.path / "run.csv");
  EXPECT_EQ(table.headings,
            (std::vector<std::string>{"time_s", "external_J_per_m", "value2", "also", "twice"}));
  ASSERT_EQ(table.columns[0].size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(table.columns[4][k], 2.0 * table.columns[0][k]);
    EXPECT_EQ(table.columns[3][k], 7.0);
  }
  EXPECT_GT(table.columns[2][2], 0.0);
}

TEST(SeriesBinding, WithoutNamesItHasTheUsefulOnesAlsoOfRecordings) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(test::scene + test::recorded + R"(
    s:log "steps.csv"
    s:log { "times.csv", every = 1*us }
    r:log "records.csv"
    s:run(1*us) s:close()
  )",
                             test::quiet(folder.path)),
            "");
  const auto names = [&](const char* file) { return read_series(folder.path / file).headings; };
  EXPECT_THAT(names("steps.csv"), testing::IsSupersetOf({"time_s", "external_J_per_m", "tip_x_m"}));
  EXPECT_THAT(names("steps.csv"), testing::Not(testing::Contains("kinetic_J_per_m")));
  EXPECT_THAT(names("times.csv"), testing::Contains("kinetic_J_per_m"));
  EXPECT_THAT(names("records.csv"), testing::Contains("strain_J_per_m"));
  EXPECT_THAT(names("records.csv"), testing::Not(testing::Contains("external_J_per_m")));
  EXPECT_EQ(read_series(folder.path / "records.csv").columns[0].size(), 2U);
}

TEST(SeriesBinding, RefusesWhatIsNoColumn) {
  const auto told = [](const char* what) {
    return test::message_of(test::scene + fmt::format("s:log {{ 'a.csv', {} }}", what));
  };
  EXPECT_THAT(told("'tip.z'"), HasSubstr("there is no column 'tip.z' (did you mean 'tip."));
  EXPECT_THAT(told("7"), HasSubstr("column 1 is 7"));
  EXPECT_THAT(told("{}"), HasSubstr("column 1 is empty"));
  EXPECT_THAT(told("{ ['a b'] = print }"), HasSubstr("letters, digits and _"));
  EXPECT_THAT(told("{ a = 3 }"), HasSubstr("not name = function"));
  EXPECT_THAT(told("'time', columns = { 'step' }"), HasSubstr("columns is given twice"));
  EXPECT_THAT(told("every = 0"), HasSubstr("every"));
  EXPECT_THAT(test::message_of(test::scene + "s:log 'a.txt'"), HasSubstr(".csv"));
  EXPECT_THAT(test::message_of(test::scene + "s:log 'a.csv' s:log 'a.csv'"),
              HasSubstr("already written"));
}

TEST(SeriesBinding, AFunctionThatReturnsNoNumberEndsTheRunAndLeavesTheRowsBefore) {
  const test::Folder folder;
  const std::string script = test::scene + R"(
    s:log { "a.csv", every = 1*us, function(s) if s.time < 1.5*us then return 1 end end }
    s:run(4*us)
  )";
  EXPECT_THAT(test::message_of(script, test::quiet(folder.path)),
              HasSubstr("log: value1: the function returns nothing at t = 2 us"));
  EXPECT_EQ(read_series(folder.path / "a.csv").columns[0].size(), 2U);
}

TEST(SeriesBinding, AReactionIsKnownByItsName) {
  EXPECT_EQ(test::message_of(R"(
    local p = plate { width = 40*mm, height = 20*mm, material = "duran50" }
    p:clamp { edge = "left", depth = 4*mm, name = "grip" }
    p:move { edge = "right", depth = 4*mm, displacement = {1e-6, 0}, time = ramp(1*us), axis = "x" }
    local s = simulate(p, { spacing = 1*mm })
    s:quasistatic { duration = 1*us, increments = 1 }
    local grip, other = s:reaction("grip"), s:reaction("support2")
    assert(grip.fx > 0 and math.abs(grip.fx + other.fx) < 1e-4*grip.fx)
    assert(math.abs(other.ux - 1e-6) < 1e-15 and grip.ux == 0 and grip.body == "support")
    assert(#s.reactions == 2 and s.reactions[1].name == "grip")
    local ok, err = pcall(s.reaction, s, "gripp")
    assert(not ok and tostring(err):find("did you mean 'grip'", 1, true), tostring(err))
    ok, err = pcall(p.clamp, p, { edge = "top", depth = 2*mm, name = "grip" })
    assert(not ok and tostring(err):find("two loads are named 'grip'", 1, true), tostring(err))
    ok, err = pcall(p.clamp, p, { edge = "top", depth = 2*mm, name = "2 fast" })
    assert(not ok and tostring(err):find("no name for a load", 1, true), tostring(err))
  )"),
            "");
}

// Python's reader is what pandas and many scripts read tables with.
TEST(SeriesBinding, PythonReadsATable) {
  HACKLE_NEEDS(std::system("python3 -c 'import csv' 2>/dev/null") == 0, "there is no python3");
  const test::Folder folder;
  ASSERT_EQ(test::message_of(test::scene + "s:log 'a.csv' s:run(2*us) s:close()",
                             test::quiet(folder.path)),
            "");
  const std::string program = fmt::format(
      "import csv; rows = list(csv.DictReader(open(\"{}\", newline=\"\"))); "
      "times = [float(row[\"time_s\"]) for row in rows]; "
      "assert len(times) == 4 and times == sorted(times) and times[0] == 0.0, times; "
      "assert all(name.isidentifier() for name in rows[0]), rows[0]",
      (folder.path / "a.csv").string());
  EXPECT_EQ(std::system(fmt::format("python3 -c '{}'", program).c_str()), 0);
}

}  // namespace
}  // namespace hackle
