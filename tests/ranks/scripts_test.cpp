// SPDX-License-Identifier: MIT
// Scripts do the same on any number of ranks: they print the same, and leave the same files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ranks/mpirun.hpp"

namespace hackle::test {
namespace {

constexpr const char* plate_of_150_rows = R"(
local p = plate { width = 40*mm, height = 75*mm, material = "duran50" }
p:crack { from = {0, 37.5*mm}, to = {20*mm, 37.5*mm} }
for edge, pull in pairs { top = 24*MPa, bottom = -24*MPa } do
  p:traction { edge = edge, stress = {0, pull} }
end
local s = simulate(p, { spacing = 0.5*mm, precision = "f32" })
)";

TEST(RanksOfScripts, HaveTheStatesOfEveryKindOfScene) {
  HACKLE_NEEDS_MPI;
  const std::string expected =
      text_of(std::filesystem::path(HACKLE_TESTS_FOLDER) / "golden/hashes.txt");
  for (const int ranks : {2, 3, 4}) {
    const Folder folder;
    const Said said = hackle(
        folder, ranks, fmt::format("run -q -j 1 \"{}/golden/scenes.lua\"", HACKLE_TESTS_FOLDER));
    EXPECT_EQ(said.code, 0) << said.err;
    EXPECT_EQ(said.out, expected) << ranks << " ranks";
  }
}

TEST(RanksOfScripts, AskAndAreToldTheSame) {
  HACKLE_NEEDS_MPI;
  const Folder folder;
  write(folder, "ask.lua", std::string(plate_of_150_rows) + R"(
local seen = 0
s:log { "series.csv", "strain", "tip.x", "external", every = 1*us }
s:on { "every", every = 2*us, call = function(t) seen = seen + s.energy.kinetic end }
s:on { "break", call = function(t) print("first bond", t) end }
s:record { "plate.h5", every = 4*us }
s:run(8*us)
s:frame { "plate.png" }
print(seen, s.hash, s.energy.strain, #s:cracks())
s:save { "plate.ckpt" }
local again = load "plate.ckpt"
again:run(4*us)
s:run(4*us)
print(again.hash == s.hash, s.hash)
s:close()
print(recording "plate.h5")
s = simulate(p, { spacing = 0.5*mm })
s:relax()
print(s.energy.strain)
)");
  const Said alone = hackle(folder, 1, "run -q -j 1 -o alone ask.lua");
  ASSERT_EQ(alone.code, 0) << alone.err;
  for (const int ranks : {2, 6}) {
    const Said said = hackle(folder, ranks, "run -q -j 1 --force -o ranks ask.lua");
    EXPECT_EQ(said.code, 0) << said.err;
    EXPECT_EQ(said.out, alone.out);
    for (const char* file : {"series.csv", "plate.png"})
      EXPECT_EQ(text_of(folder.path / "ranks" / file), text_of(folder.path / "alone" / file));
  }
}

TEST(RanksOfScripts, GoOnFromTheCheckpointsOfAnyNumber) {
  HACKLE_NEEDS_MPI;
  const Folder folder;
  write(folder, "plate.lua",
        std::string(plate_of_150_rows) +
            "s:run(8*us) if arg[1] then error(\"stop\") end "
            "s:run(4*us) print(s.hash)\n");
  write(folder, "whole.lua", std::string(plate_of_150_rows) + "s:run(12*us) print(s.hash)\n");
  const std::string hash = hackle(folder, 1, "run -q -j 1 whole.lua").out;
  write(folder, "first.lua",
        std::string(plate_of_150_rows) + "s:run(8*us) s:save { \"a.ckpt\" }\n");
  write(folder, "second.lua", "s = load \"a.ckpt\" s:run(4*us) print(s.hash)\n");
  EXPECT_EQ(hackle(folder, 3, "run -q -j 1 -o both first.lua").code, 0);
  for (const int ranks : {1, 2, 4}) {
    const Said said = hackle(folder, ranks, "run -q -j 1 -o both --force second.lua");
    EXPECT_EQ(said.out, hash) << ranks << said.err;
  }
}

TEST(RanksOfScripts, RunWhatIsTypedAtThePromptOfTheFirst) {
  HACKLE_NEEDS_MPI;
  const Folder folder;
  write(folder, "typed",
        std::string(plate_of_150_rows).replace(0, 1, "") +
            "_G.s = s\ns:run(2*us)\ns.hash\nos.exit(0)\n");
  std::string typed = text_of(folder.path / "typed");
  for (std::size_t at = 0; (at = typed.find("local ", at)) != std::string::npos;)
    typed.replace(at, 6, "");
  write(folder, "typed", typed);
  const Said alone = shell(folder, fmt::format("\"{}\" < typed", HACKLE_PROGRAM));
  const Said said =
      shell(folder, fmt::format("mpirun --allow-run-as-root --oversubscribe -n 3 \"{}\" < typed",
                                HACKLE_PROGRAM));
  EXPECT_EQ(said.code, 0) << said.err;
  // It sees a terminal of mpirun, so long lines may be broken.
  const std::string hash = alone.out.substr(alone.out.size() - 17);
  EXPECT_THAT(said.out, testing::EndsWith(hash));
}

}  // namespace
}  // namespace hackle::test
