// SPDX-License-Identifier: MIT
#include "console/schema/point_file.hpp"

#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string objection_to_points(const std::string& text, std::size_t max = 100) {
  try {
    points_in_text(text, max, "'a.csv'");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(PointFile, TakesWhatProgramsWrite) {
  const Vec2 one{1, -2.5}, two{3e-3, 4};
  for (const char* text :
       {"1,-2.5\n3e-3,4\n", "1, -2.5\r\n0.003, 4", "1;-2.5\n+3e-3 ; 4", "1 -2.5\n3e-3   4",
        "1\t-2.5\n3E-3\t4\n", "x, y\n1, -2.5\n3e-3, 4",
        "\n\n# from a scan\nx;y\n\n1;-2.5\n3e-3;4\n\n", "\xEF\xBB\xBFx,y\n1,-2.5\n3e-3,4"})
    EXPECT_THAT(points_in_text(text, 2, "a"), ElementsAre(one, two)) << text;
  EXPECT_TRUE(points_in_text("", 2, "a").empty());
  EXPECT_TRUE(points_in_text("x, y\n", 2, "a").empty());
}

TEST(PointFile, NamesTheLineThatIsNoPoint) {
  for (const char* text : {"1,2\n3\n", "1,2\n3,4,5\n", "1,2\nx,y\n", "1,2\nnan,1\n", "1,2\n1,inf\n",
                           "1,2\n1e999,1\n", "1,2\n1,2x\n", "1,2\n,\n", "x,y\nx,y\n",
                           "# 1\n1,2,3\n", "a,1\nsecret,2\n", "1,2\n1,5;2,5\n"})
    EXPECT_THAT(objection_to_points(text), HasSubstr("'a.csv', line ")) << text;
  EXPECT_THAT(objection_to_points("x,y\n1,2\n\nsecret,7\n"),
              HasSubstr("'a.csv', line 4 is no point"));
  EXPECT_THAT(objection_to_points("1,2\nsecret,7\n"), testing::Not(HasSubstr("secret")));
  EXPECT_THAT(objection_to_points(std::string("\0\1\2,\n\3", 6)), HasSubstr("line 2"));
  EXPECT_THAT(objection_to_points(std::string(1 << 20, '7')), HasSubstr("line 1"));
  EXPECT_THAT(objection_to_points("1e999,1e999\n1,2\n"), HasSubstr("line 1"));
  EXPECT_THAT(objection_to_points("1,2\n3,4\n5,6\n", 2),
              HasSubstr("line 3: there are more than 2"));
}

// A plate of 40 x 30 mm with a rectangular hole whose corners stand in h.csv, in mm.
class HoleOfAFile : public testing::Test {
 protected:
  void SetUp() override { write("x [mm], y [mm]\n10, 10\n30, 10\n30, 20\n10, 20\n10, 10\n"); }
  void write(const std::string& text) const { write_text(file(), text); }
  std::filesystem::path file() const { return folder_.path / "h.csv"; }
  std::string message(const std::string& script, bool trust = false) const {
    const std::string plate = "p = plate { width = 40*mm, height = 30*mm, material = 'duran50' }\n";
    return test::message_of(plate + script,
                            trust ? test::trusted(folder_.path) : test::quiet(folder_.path));
  }
  test::Folder folder_;
};

constexpr const char* by_file = "p:hole { points = 'h.csv', unit = mm }";

TEST_F(HoleOfAFile, IsThatOfTheSameList) {
  EXPECT_EQ(message(std::string(by_file) + R"(
    local q = plate { width = 40*mm, height = 30*mm, material = 'duran50' }
    q:hole { points = {{10, 10}, {30, 10}, {30, 20}, {10, 20}}, unit = mm }
    local function solved(plate)
      plate:traction { edge = 'top', stress = {0, 1*MPa} }
      local s = simulate(plate, { spacing = 1*mm })
      s:run(3*us)
      return s.hash
    end
    assert(solved(p) == solved(q)))"),
            "");
}

TEST_F(HoleOfAFile, MayBeAnOutlineAnInclusionOrACrack) {
  EXPECT_EQ(message(R"(
    p:keep { points = 'h.csv', unit = mm }
    assert(simulate(p, { spacing = 1*mm }):fragments()[1].nodes == 200)
    p:keep { any = { { points = 'h.csv', unit = mm }, { centre = {5*mm, 5*mm}, radius = 2*mm } } }
    p:inclusion { points = 'h.csv', unit = mm, material = 'soda_lime' }
    p:crack { points = 'h.csv', unit = mm }
    p:crack { points = {{1, 1}, {2, 2}}, unit = mm }
    local d = plate { width = 40*mm, height = 30*mm, outline = { points = 'h.csv', unit = mm },
                      material = 'duran50' }
    assert(simulate(d, { spacing = 1*mm }):fragments()[1].nodes == 200))"),
            "");
}

TEST_F(HoleOfAFile, IsKeptByARunFileWithoutTheFile) {
  Console console(test::quiet(folder_.path));
  console.evaluate(
      std::string("p = plate { width = 40*mm, height = 30*mm, material = 'duran50' } ") + by_file +
      " s = simulate(p, { spacing = 1*mm }) s:record { 'r.h5', every = 1*us } "
      "s:run(1*us) s:close()");
  std::filesystem::remove(file());
  // Opening it builds the lattice again and compares it with the recorded one.
  EXPECT_NO_THROW(console.evaluate("recording 'r.h5'"));
}

TEST_F(HoleOfAFile, IsRefusedWithTheReason) {
  const auto refused = [&](const std::string& text) {
    write(text);
    return message(by_file);
  };
  EXPECT_THAT(refused(""), HasSubstr("h.csv' has 0 points, there must be between 3 and 10000"));
  EXPECT_THAT(refused("1,1\n2,2\n"), HasSubstr("has 2 points"));
  EXPECT_THAT(refused("1,1\n2,nan\n3,0"), HasSubstr("hole: points: "));
  EXPECT_THAT(refused("1,1\n2,nan\n3,0"), HasSubstr("line 2 is no point"));
  EXPECT_THAT(refused("10,10\n30,20\n30,10\n10,20\n"),
              HasSubstr("the side from point 1 of 'h.csv' crosses that from point 3"));
  EXPECT_THAT(refused(std::string(max_point_file + 1, '\n')), HasSubstr("larger than 1 MiB"));
  std::string many;
  for (int k = 0; k <= 10000; ++k) many += std::to_string(k) + ",0\n";
  EXPECT_THAT(refused(many), HasSubstr("line 10001: there are more than 10000 points"));
  EXPECT_THAT(message("p:hole { points = 'none.csv' }"), HasSubstr("no such file"));
  EXPECT_THAT(message("p:hole { points = '.' }"), HasSubstr("it is a folder"));
  EXPECT_THAT(message("p:hole { points = '' }"), HasSubstr("empty text"));
  EXPECT_THAT(message("p:hole { centre = {1, 1}, radius = 1, unit = mm }"), HasSubstr("not clear"));
  EXPECT_THAT(message("p:hole { points = 'h.csv', unit = 0 }"), HasSubstr("unit is 0"));
}

// With --trust, too: neither ever ends.
TEST_F(HoleOfAFile, IsNoPipeOrDevice) {
  ASSERT_EQ(mkfifo((folder_.path / "pipe").c_str(), 0600), 0);
  for (const bool trust : {false, true})
    EXPECT_THAT(message("p:hole { points = 'pipe' }", trust), HasSubstr("is no plain file"));
  EXPECT_THAT(message("p:hole { points = '/dev/zero' }", true), HasSubstr("is no plain file"));
  EXPECT_THAT(message("p:hole { points = '/etc/passwd' }"),
              HasSubstr("outside of what a script may"));
}

}  // namespace
}  // namespace hackle
