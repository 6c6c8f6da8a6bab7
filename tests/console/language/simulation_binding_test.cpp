// SPDX-License-Identifier: MIT
#include "console/language/simulation_binding.hpp"

#include <gmock/gmock.h>

#include "base/files.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(SimulationBinding, FieldsSayWhatWasSolved) {
  EXPECT_EQ(test::message_of(test::scene + R"(
    assert(s.nodes == 1000 and s.bonds > 15000 and s.steps == 0 and s.time == 0)
    s:step(3)
    s:step()
    assert(s.steps == 4 and s.dt < s.dt_limit and math.abs(s.time - 4*s.dt) < 1e-12)
    assert(s.energy.external > 0 and s.damage.broken_bonds >= 0 and s.damage.most < 1 and #s.hash == 16)
    s:run(2*us)
    assert(s.time >= 4*s.dt + 2*us - 1e-12)
  )"),
            "");
}

TEST(SimulationBinding, ReadsInOneLine) {
  EXPECT_EQ(test::message_of(test::scene + R"(
    local text = tostring(s)
    assert(text:find("^1 000 nodes, %d+ %d+ bonds, horizon 8 mm %(m = 4%), step [%d.]+ ns "), text)
  )"),
            "");
}

TEST(SimulationBinding, TakesEveryQuadratureMicromodulusAndPrecision) {
  EXPECT_EQ(test::message_of(R"(
    for _, plane in ipairs { "stress", "strain" } do
      local p = plate { width = 60*mm, height = 40*mm, material = "duran50", plane = plane }
      for _, quadrature in ipairs { "full", "ramp", "area", "centroid" } do
        for _, micromodulus in ipairs { "constant", "conical" } do
          local s = simulate(p, { spacing = 4*mm, quadrature = quadrature,
                                  micromodulus = micromodulus, precision = "f32" })
          s:step(2)
          local text = s:report()
          assert(text:find("plane " .. plane, 1, true), text)
          assert(text:find(quadrature .. " quadrature", 1, true), text)
          assert(text:find(micromodulus .. " micromodulus: E 65 GPa", 1, true), text)
        end
      end
    end
  )"),
            "");
}

TEST(SimulationBinding, SolvesACopyOfThePlate) {
  EXPECT_EQ(test::message_of(test::scene + R"(
    local bonds = s.bonds
    p:crack { from = {60*mm, 20*mm}, to = {90*mm, 20*mm}, born = "absent" }
    assert(s.bonds == bonds)
    assert(simulate(p, { spacing = 2*mm }).bonds < bonds)
  )"),
            "");
}

TEST(SimulationBinding, ExpectsAPlateFirst) {
  EXPECT_THAT(test::message_of("simulate { spacing = 1*mm }"),
              HasSubstr("simulate: expected a plate first, got a table (as in s = simulate(p, {"));
}

TEST(SimulationBinding, FilesOfAClosedRunAreComplete) {
  const test::Folder folder;
  Console console(test::quiet(folder.path));
  console.run_text(test::scene + R"(
    s:movie { "a.mp4", every = 0.9*us }
    s:record { file = "sub/a.h5", every = 1*us }
    s:run(2*us)
    s:frame "a.png"
  )",
                   "test.lua");
  for (const char* name : {"a.mp4", "sub/a.h5", "sub/a.xdmf", "a.png"})
    EXPECT_TRUE(fs::exists(folder.path / name)) << name;
  ASSERT_EQ(console.simulations().size(), 1u);
  EXPECT_EQ(console.simulations()[0].files.size(), 4u);
}

TEST(SimulationBinding, TheEndingOfAMovieSaysItsKind) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(test::scene + R"(
    s:movie { "a.mp4", every = 1*us, width = 320, profile = "preview", crf = 40, hold = 0 }
    s:movie { "a.webp", every = 1*us, width = 320, profile = "lossless" }
    s:movie { "a.gif", every = 1*us, width = 320, fps = 10, fallback = true }
    s:run(2*us)
  )",
                             test::quiet(folder.path)),
            "");
  for (const char* name : {"a.mp4", "a.webp", "a.gif"})
    EXPECT_TRUE(fs::exists(folder.path / name)) << name;
}

TEST(SimulationBinding, RefusesWhatAMovieOfItsKindCannotBe) {
  const auto message = [](const std::string& options) {
    return test::message_of(test::scene + "s:movie { " + options + ", every = 1*us }");
  };
  EXPECT_THAT(message("'a.mp3'"), HasSubstr("movie: 'a.mp3' ends in '.mp3'"));
  EXPECT_THAT(message("'a.mp4', profile = 'lossless'"), HasSubstr("cannot be lossless"));
  EXPECT_THAT(message("'a.gif', crf = 20"), HasSubstr("crf has no meaning in .gif"));
  EXPECT_THAT(message("'a.gif', fps = 60"), HasSubstr("in .gif it must lie between"));
}

TEST(SimulationBinding, FilesAreCompleteAfterAnErrorToo) {
  const test::Folder folder;
  EXPECT_THAT(
      test::message_of(test::scene + "s:movie { 'a.mp4', every = 1*us }\ns:run(1*us)\nerror 'oops'",
                       test::quiet(folder.path)),
      HasSubstr("oops"));
  EXPECT_TRUE(fs::exists(folder.path / "a.mp4"));
}

TEST(SimulationBinding, AbsoluteNamesAreTakenAsTheyAre) {
  const test::Folder folder;
  const std::string name = (folder.path / "there.png").string();
  EXPECT_EQ(test::message_of(test::scene + "s:frame { '" + name + "' }",
                             test::trusted(folder.path / "elsewhere")),
            "");
  EXPECT_TRUE(fs::exists(name));
  EXPECT_FALSE(fs::exists(folder.path / "elsewhere"));
}

TEST(SimulationBinding, AForgottenSimulationGivesBackItsMemoryAndKeepsItsSummary) {
  Console console(test::quiet());
  console.run_text(test::scene + R"(
    s:step(2)
    local watch = setmetatable({ s }, { __mode = "v" })
    s = nil
    s = simulate(p, { spacing = 4*mm, horizon = 8*mm })
    assert(watch[1] == nil)
  )",
                   "test.lua");
  const auto list = console.simulations();
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].steps, 2);
  EXPECT_EQ(list[0].nodes, 1000);
  EXPECT_EQ(list[1].nodes, 250);
}

}  // namespace
}  // namespace hackle
