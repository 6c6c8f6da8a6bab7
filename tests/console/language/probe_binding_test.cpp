// SPDX-License-Identifier: MIT
// gauge, s:read and s:values.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "console/scripts.hpp"
#include "store/series_file.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

const std::string sheared = R"(
p = plate { width = 40*mm, height = 20*mm, material = "duran50" }
p:initial { displacement = function(x, y) return 1e-5*x, 2e-5*y end }
s = simulate(p, { spacing = 1*mm })
)";

TEST(ProbeBinding, GaugesReadAndAreColumns) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(sheared + R"(
    local function near(a, b) assert(math.abs(a - b) < 1e-9*math.abs(b), a .. " is not " .. b) end
    local clip = gauge { "extension", from = {5*mm, 3*mm}, to = {25*mm, 3*mm}, name = "clip" }
    near(s:read(clip), 20*mm*1e-5)
    near(s:read { "strain", from = {5*mm, 3*mm}, to = {5*mm, 13*mm} }, 2e-5)
    near(s:read { "point", at = {7.3*mm, 0.1*mm}, of = "ux" }, 7.3*mm*1e-5)
    near(s:read { "line", from = {0, 5*mm}, to = {40*mm, 5*mm}, of = "ux" }, 20*mm*1e-5)
    near(s:read { "region", centre = {20*mm, 10*mm}, radius = 4*mm, of = "uy" }, 10*mm*2e-5)
    near(s:read { "region", from = {10*mm, 5*mm}, to = {12*mm, 7*mm}, of = "strain_yy" }, 2e-5)
    assert(clip.name == "clip" and clip.unit == "m", tostring(clip))
    s:log { "a.csv", clip, { steps = function(s) return s.steps end } }
    s:record { "r.h5", every = 1*us }
    s:run(1*us) s:close()
    local r = recording "r.h5"
    assert(math.abs(r:read(clip)/(20*mm*1e-5) - 1) < 1e-4)  -- records are floats
    r:log { "b.csv", clip }
  )",
                             test::quiet(folder.path)),
            "");
  const SeriesTable table = read_series(folder.path / "a.csv");
  EXPECT_EQ(table.headings, (std::vector<std::string>{"time_s", "clip_m", "steps"}));
  EXPECT_NEAR(table.columns[1][0], 20e-3 * 1e-5, 1e-15);
  EXPECT_EQ(read_series(folder.path / "b.csv").headings[1], "clip_m");
}

TEST(ProbeBinding, RefusesWhatReadsNothing) {
  const auto told = [](const char* call) { return test::message_of(sheared + call); };
  EXPECT_THAT(told("s:read { 'point', at = {50*mm, 0} }"), HasSubstr("lies off the plate"));
  EXPECT_THAT(told("gauge { 'opening', from = {0, 0} }"),
              HasSubstr("gauge: it is not clear where the opening is"));
  EXPECT_THAT(told("gauge { 'strain', from = {0, 0}, to = {0, 0} }"), HasSubstr("same place"));
  EXPECT_THAT(told("gauge { 'point', at = {0, 0}, name = 'a b' }"), HasSubstr("no name"));
  EXPECT_THAT(told("gauge { 'point', at = {0, 0}, of = 'uz' }"), HasSubstr("expected one of ux"));
  EXPECT_THAT(told("local g = gauge { 'point', at = {0, 0} } s:log { 'a.csv', g, g }"),
              HasSubstr("two columns are named 'point_m'"));
}

TEST(ProbeBinding, ValuesAreAFieldOfTheirMoment) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(sheared + R"(
    local v = s:values("displacement_x")
    s:run(2*us)
    local top = v:max()
    assert(math.abs(top.x - 39.5*mm) < 1e-12 and math.abs(top.value/(39.5*mm*1e-5) - 1) < 1e-6)
    assert(math.abs(v:at({10*mm, 10*mm})/(10*mm*1e-5) - 1) < 1e-6 and v:at({50*mm, 0}) == nil)
    assert(math.abs(v:mean()/(20*mm*1e-5) - 1) < 1e-6 and v.time == 0 and v.unit == "m")
    assert(math.abs(v:mean { from = {0, 0}, to = {2*mm, 2*mm} }/(1*mm*1e-5) - 1) < 1e-6)
    v:save "x.csv" v:save "x.png"
    local ok, err = pcall(s.values, s, "stres_1")
    assert(not ok and tostring(err):find("did you mean 'stress_1'", 1, true), tostring(err))
  )",
                             test::quiet(folder.path)),
            "");
  const SeriesTable table = read_series(folder.path / "x.csv");
  EXPECT_EQ(table.headings, (std::vector<std::string>{"x_m", "y_m", "displacement_x_m"}));
  ASSERT_EQ(table.columns[0].size(), 800U);
  for (std::size_t k = 0; k < 800; ++k)
    EXPECT_NEAR(table.columns[2][k], 1e-5 * table.columns[0][k], 1e-13);
  EXPECT_GT(std::filesystem::file_size(folder.path / "x.png"), 100U);
}

}  // namespace
}  // namespace hackle
