// SPDX-License-Identifier: MIT
#include "study/case_runner.hpp"

#include <algorithm>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "study/quantity.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

class CaseRunnerTest : public testing::Test {
 protected:
  CaseRunnerTest() { write_text(script_, R"({"fork": 0.06, "fails": "bad"})"); }

  CaseRunner runner(bool fresh = false) const {
    return {{.program = FAKE_HACKLE, .path = script_, .settings = {}, .arguments = {}},
            {.folder = folder_.path / "study", .threads = 2, .talk = Talk::quiet, .fresh = fresh}};
  }
  // How often the program has been called.
  long calls() const {
    const std::string log = read_text(script_.string() + ".calls");
    return std::ranges::count(log, '\n');
  }
  static Case with(const Settings& settings) { return {settings, 1e-6, false}; }

  test::Folder folder_;
  const std::filesystem::path script_ = folder_.path / "scene.lua";
};

TEST_F(CaseRunnerTest, ReturnsOutcomesInOrder) {
  const std::vector<Case> cases{with({{"simulate.spacing", "0.002"}}), with({}),
                                with({{"simulate.spacing", "0.004"}})};
  const std::vector<Outcome> outcomes = runner().run(cases, "test");
  ASSERT_EQ(outcomes.size(), 3U);
  EXPECT_EQ(outcomes[0].told["numerics"]["spacing_m"], 0.002);
  EXPECT_EQ(outcomes[1].told["numerics"]["spacing_m"], 0.001);
  EXPECT_EQ(outcomes[2].told["numerics"]["spacing_m"], 0.004);
  for (const Outcome& outcome : outcomes) {
    EXPECT_TRUE(outcome.finished());
    EXPECT_GT(outcome.peak_bytes, 0U);
    EXPECT_GT(outcome.wall, 0.0);
  }
}

TEST_F(CaseRunnerTest, RunsNothingTwice) {
  const std::vector<Case> cases{with({}), with({{"simulate.spacing", "0.002"}})};
  const std::vector<Outcome> first = runner().run(cases, "test");
  EXPECT_EQ(calls(), 2);
  CaseRunner again = runner();
  const std::vector<Outcome> second = again.run(cases, "test");
  EXPECT_EQ(calls(), 2);
  EXPECT_EQ(again.runs(), 0);
  EXPECT_EQ(first[1].told, second[1].told);
  EXPECT_EQ(first[1].cpu, second[1].cpu);
  runner(true).run(cases, "test");
  EXPECT_EQ(calls(), 4) << "unless it is told to";
}

TEST_F(CaseRunnerTest, RunsAgainWhatHasChanged) {
  const std::vector<Case> cases{with({})};
  runner().run(cases, "test");
  write_text(script_, R"({"fork": 0.07})");
  const QuantityRow row = *quantity_named("fork.place");
  EXPECT_GT(value_of(runner().run(cases, "test")[0], row).place->x(), 0.065);
  write_text(folder_.path / "module.lua", "return 1");
  runner().run(cases, "test");
  EXPECT_EQ(calls(), 3) << "a file beside the script may be a module";
}

TEST_F(CaseRunnerTest, KeepsTheReasonOfAFailure) {
  const std::vector<Case> cases{with({{"bad", "1"}})};
  for (int k = 0; k < 2; ++k) {
    const Outcome outcome = runner().run(cases, "test")[0];
    EXPECT_EQ(outcome.state, CaseState::failed);
    EXPECT_EQ(outcome.reason, "this cannot be (do otherwise)");
    try {
      finished(outcome);
      FAIL();
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("the run with bad 1 did not finish: this cannot be"));
    }
  }
}

TEST_F(CaseRunnerTest, SaysWhichScriptItCannotRead) {
  EXPECT_THROW(CaseRunner({.program = FAKE_HACKLE, .path = folder_.path / "none.lua"},
                          {.folder = folder_.path}),
               Error);
}

}  // namespace
}  // namespace hackle
