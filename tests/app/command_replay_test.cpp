// SPDX-License-Identifier: MIT
#include "app/command_replay.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/program.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using ReplayedJson = nlohmann::json;

constexpr const char* recorded_script = R"(
local p = plate { width = 20*mm, height = 10*mm, material = "duran50" }
p:traction { edge = "top", stress = {0, 20*MPa} }
local s = simulate(p, { spacing = 0.5*mm, horizon = 1.5*mm })
s:record { "a.h5", every = 1*us }
s:run(3*us)
s:traction { edge = "bottom", stress = {0, -20*MPa} }
s:run(3*us)
)";

TEST(CommandReplay, ComputesTheRunAgainAndSaysThatItAgrees) {
  const test::Folder folder;
  const test::Program program(folder);
  std::ofstream(folder.path / "a.lua") << recorded_script;
  ASSERT_EQ(program.run({"run", "-q", "a.lua", "-o", "."}).code, 0);
  const test::Ended plain = program.run({"replay", "a.h5", "-j", "2"});
  EXPECT_EQ(plain.code, 0) << plain.err;
  EXPECT_THAT(plain.out, HasSubstr("all 7 records agree"));
  const ReplayedJson json = ReplayedJson::parse(program.run({"replay", "--json", "a.h5"}).out);
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("records"), 7);
  EXPECT_EQ(json.at("compared"), 7);
  EXPECT_EQ(json.at("agrees"), true);
  EXPECT_FALSE(json.contains("difference"));
  EXPECT_EQ(program.run({"replay", "a.lua"}).code, 5);
  EXPECT_EQ(program.run({"replay"}).code, 2);
}

Proof differing() {
  Proof proof;
  proof.records = 9;
  proof.compared = 3;
  proof.has_hashes = true;
  proof.difference = Discrepancy{.record = 2,
                                 .time = 2e-6,
                                 .step = 40,
                                 .quantity = "broken",
                                 .node = Vec2(5, 7),
                                 .place = Vec2(2.75e-3, 3.75e-3),
                                 .detail = "bond to the node 1 columns and 0 rows on",
                                 .recorded = "broken",
                                 .computed = "intact"};
  return proof;
}

TEST(CommandReplay, NamesRecordNodeAndQuantity) {
  EXPECT_EQ(text_of(differing(), "a.h5"),
            "a.h5: record 2 at 2 us (step 40) differs: broken of node (5, 7) at {2.75, 3.75} mm, "
            "bond to the node 1 columns and 0 rows on is broken in the file, intact computed\n"
            "the hash of its state agrees: the file has been changed since\n");
  const ReplayedJson json = to_json(differing(), "a.h5");
  EXPECT_EQ(json.at("agrees"), false);
  EXPECT_EQ(json.at("difference").at("record"), 2);
  EXPECT_EQ(json.at("difference").at("node"), (ReplayedJson{5, 7}));
  EXPECT_EQ(json.at("difference").at("quantity"), "broken");
  EXPECT_EQ(json.at("difference").at("hash_agrees"), true);
}

TEST(CommandReplay, SaysThatFieldsAreEqualWhereOnlyTheHashDiffers) {
  Proof proof = differing();
  proof.exact_hash = false;
  proof.difference->quantity = "state_hash";
  proof.difference->node.reset();
  EXPECT_THAT(text_of(proof, "a.h5"), HasSubstr("all that is recorded of it is equal"));
}

}  // namespace
}  // namespace hackle
