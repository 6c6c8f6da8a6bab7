// SPDX-License-Identifier: MIT
#include "study/case_runner.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <thread>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "study/case_claim.hpp"
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
            {.folder = folder_.path / "study",
             .threads = 2,
             .talk = Talk::quiet,
             .notes = true,
             .fresh = fresh}};
  }
  // How often the program has been called.
  long calls() const {
    const std::string log = read_text(script_.string() + ".calls");
    return std::ranges::count(log, '\n');
  }
  static std::filesystem::path outcome_of(const CaseRunner& one, const Case& of) {
    return one.folder_of(of).string() + ".json";
  }
  static std::filesystem::path lock_of(const CaseRunner& one, const Case& of) {
    return one.folder_of(of).string() + ".lock";
  }
  static std::optional<CaseClaim> claimed(const CaseRunner& one, const Case& of) {
    make_folder_of(lock_of(one, of));
    return CaseClaim::of(lock_of(one, of), {"node3", 1, "", 0.0, false}, true);
  }
  std::vector<std::filesystem::path> locks() const {
    std::vector<std::filesystem::path> all;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path / "study/cases"))
      if (entry.path().extension() == ".lock") all.push_back(entry.path());
    return all;
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

TEST_F(CaseRunnerTest, KeepsHowLongAStoppedCaseHad) {
  const std::vector<Case> cases{with({})};
  EXPECT_EQ(runner().run(cases, "test", 1e-9)[0].state, CaseState::stopped);
  CaseRunner again = runner();
  EXPECT_EQ(again.run(cases, "test", 1e-9)[0].state, CaseState::stopped);
  EXPECT_EQ(again.runs(), 0);
  EXPECT_TRUE(again.run(cases, "test", 60.0)[0].finished()) << "more time is another case";
  EXPECT_EQ(again.runs(), 1);
}

// Three processes with one folder, here threads: locks do not see the difference.
TEST_F(CaseRunnerTest, SeveralRunEachCaseOnce) {
  std::vector<Case> cases;
  for (int k = 1; k <= 24; ++k)
    cases.push_back(with({{"simulate.spacing", std::to_string(1e-3 * k)}}));
  std::vector<std::vector<Outcome>> found(3);
  {
    std::vector<std::jthread> threads;
    for (auto& outcomes : found)
      threads.emplace_back([&] { outcomes = runner().run(cases, "test"); });
  }
  EXPECT_EQ(calls(), 24);
  for (std::size_t k = 0; k < cases.size(); ++k)
    for (const auto& outcomes : found) {
      EXPECT_NEAR(outcomes[k].told["numerics"]["spacing_m"].get<double>(),
                  1e-3 * static_cast<double>(k + 1), 1e-9);
      EXPECT_EQ(outcomes[k].cpu, found[0][k].cpu);
    }
  EXPECT_TRUE(locks().empty());
}

TEST_F(CaseRunnerTest, TakesACaseThatItsHolderGivesUp) {
  const std::vector<Case> cases{with({}), with({{"simulate.spacing", "0.002"}})};
  CaseRunner mine = runner();
  auto claim = claimed(mine, cases[0]);
  std::vector<Outcome> outcomes;
  {
    const std::jthread thread([&] { outcomes = mine.run(cases, "test"); });
    while (!std::filesystem::exists(outcome_of(mine, cases[1])))
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    EXPECT_FALSE(std::filesystem::exists(outcome_of(mine, cases[0])));
    claim.reset();
  }
  EXPECT_TRUE(outcomes[0].finished());
  EXPECT_FALSE(outcomes[0].made.taken_over);
  EXPECT_EQ(calls(), 2);
}

TEST_F(CaseRunnerTest, ReadsAnOutcomeThatAppears) {
  const std::vector<Case> cases{with({})};
  CaseRunner mine = runner();
  mine.run(cases, "test");
  const auto file = outcome_of(mine, cases[0]);
  const std::string text = read_text(file);
  std::filesystem::remove(file);
  auto claim = claimed(mine, cases[0]);
  std::vector<Outcome> outcomes;
  {
    const std::jthread thread([&] { outcomes = mine.run(cases, "test"); });
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    write_text(file, text);
  }
  EXPECT_TRUE(outcomes[0].finished());
  EXPECT_EQ(calls(), 1);
}

TEST_F(CaseRunnerTest, TakesOverFromAProcessThatDied) {
  const std::vector<Case> cases{with({})};
  CaseRunner mine = runner();
  make_folder_of(lock_of(mine, cases[0]));
  write_text(lock_of(mine, cases[0]), R"({"machine": "node3", "process": 4711})");
  testing::internal::CaptureStderr();
  EXPECT_TRUE(mine.run(cases, "test")[0].made.taken_over);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              HasSubstr("process 4711 on node3 ended while it ran as written"));
  EXPECT_TRUE(locks().empty());
  EXPECT_TRUE(runner().run(cases, "test")[0].made.taken_over) << "which is kept";
}

TEST_F(CaseRunnerTest, FreshRunsAgainWhatIsKeptButNothingTwice) {
  const std::vector<Case> cases{with({}), with({{"simulate.spacing", "0.002"}})};
  runner().run(cases, "test");
  CaseRunner fresh = runner(true);
  fresh.run_alone(cases[0], "test");
  fresh.run(cases, "test");
  EXPECT_EQ(calls(), 4);
  EXPECT_EQ(fresh.runs(), 2);
}

}  // namespace
}  // namespace hackle
