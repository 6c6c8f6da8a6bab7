// SPDX-License-Identifier: MIT
// A trade of a scene whose errors are known: see fake_hackle.cpp.
#include "study/trade.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/files.hpp"
#include "study/trade_report.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

class TradeTest : public testing::Test {
 protected:
  Trade traded(const std::string& model, const std::vector<std::string>& names = {},
               const TradeOptions& options = {}) const {
    const auto script = folder_.path / "scene.lua";
    write_text(script, model);
    CaseRunner runner({.program = FAKE_HACKLE, .path = script, .settings = {}, .arguments = {}},
                      {.folder = folder_.path / "study", .threads = 2, .talk = Talk::quiet});
    return trade(runner, quantities_named(names), options);
  }
  static double spacing_of(const TradeRun& run) {
    const auto at = run.settings.find("simulate.spacing");
    return at == run.settings.end() ? 1e-3 : std::stod(at->second);
  }
  static const TradeRun& run_with(const Trade& trade, const Settings& settings) {
    const auto run = std::ranges::find_if(
        trade.runs, [&](const TradeRun& one) { return one.settings == settings; });
    EXPECT_NE(run, trade.runs.end()) << name_of(settings);
    return *run;
  }

  test::Folder folder_;
};

TEST_F(TradeTest, MeasuresTheErrorOfEveryRun) {
  const Trade trade = traded(R"({"a": 0.5, "p": 1, "spacing": 1e-3})");
  const double reference = 0.5 * 0.5e-3;  // of half the spacing
  EXPECT_NEAR(*trade.runs[0].errors.at("fork.place"), 0.5 * 1e-3 - reference, 1e-12);
  EXPECT_NEAR(*trade.runs[0].errors.at("tip.path"), 0.5 * 1e-3 - reference, 1e-12);
  EXPECT_NEAR(*trade.runs[0].errors.at("fork.time"), (0.5 * 1e-3 - reference) / 1000.0, 1e-15);
  const Settings coarse{{"simulate.horizon", "0.008"}, {"simulate.spacing", "0.002"}};
  EXPECT_NEAR(*run_with(trade, coarse).errors.at("fork.place"), 0.5 * 2e-3 - reference, 1e-12);
  EXPECT_NEAR(*trade.runs[0].errors.at("residual"), 0.9e-3, 1e-15);
}

TEST_F(TradeTest, RecommendsFromTheFront) {
  const Trade trade = traded(R"({"a": 0.5, "p": 1, "spacing": 1e-3})");
  ASSERT_FALSE(trade.recommended.empty());
  for (const Recommendation& one : trade.recommended) {
    EXPECT_TRUE(trade.runs[one.run].on_front);
    EXPECT_LE(trade.runs[one.run].outcome.cpu, one.budget);
  }
  for (const TradeRun& run : trade.runs) {
    const bool of_model = run.settings.contains("material.alpha");
    EXPECT_FALSE(run.on_front && of_model);
  }
}

TEST_F(TradeTest, SaysWhatChanceAloneMoves) {
  const Trade still = traded(R"({"a": 0.5})");
  EXPECT_EQ(*still.noise.at("fork.place"), 0.0);
  EXPECT_THAT(text_of(still), HasSubstr("moves nothing"));
  const double moved = 3e-3;  // of the fork, by the last bits of E
  const Trade chaotic = traded(fmt::format(R"({{"a": 0.5, "bits": {}}})",
                                           moved / (65e9 * (1.0 + std::ldexp(1.0, -50)) - 65e9)));
  EXPECT_NEAR(*chaotic.noise.at("fork.place"), moved, 0.01 * moved);
  EXPECT_THAT(text_of(chaotic), HasSubstr("as chance does: "));
}

TEST_F(TradeTest, ComparesOnlyWhatIsAskedFor) {
  const Trade trade = traded(R"({"a": 0.5})", {"fork.time"});
  EXPECT_EQ(trade.runs[0].errors.size(), 1U);
  const double allowed = 0.01 * 1e-4;  // 1 % of the run's time
  EXPECT_DOUBLE_EQ(trade.runs[0].error, *trade.runs[0].errors.at("fork.time") / allowed);
}

TEST_F(TradeTest, GoesOnWithoutWhatTheSceneRefuses) {
  const Trade trade = traded(R"({"a": 0.5, "fails": "simulate.surface"})");
  EXPECT_FALSE(trade.reference.settings.contains("simulate.surface"));
  const TradeRun& failed = run_with(trade, {{"simulate.surface", "energy"}});
  EXPECT_FALSE(failed.on_front);
  EXPECT_EQ(failed.outcome.reason, "this cannot be (do otherwise)");
  EXPECT_TRUE(to_json(trade)["runs"].is_array());
}

// The scale of the lattice that fake_hackle is run on is known: its error is a dx.
TEST_F(TradeTest, ScreensCostlyScenesOnACoarserLattice) {
  const Trade trade =
      traded(R"({"a": 0.5, "p": 1, "spacing": 1e-3})", {}, {.costly = 0.0, .screening = 1e-9});
  EXPECT_GT(trade.screened_at, 1.0);
  EXPECT_NEAR(*trade.runs[0].errors.at("fork.place"), 0.5 * (1e-3 - spacing_of(trade.reference)),
              1e-12)
      << "as written is on its own lattice, and so is the reference";
  EXPECT_LE(trade.runs.size(), 9U);  // and the eight best ways
  for (const TradeRun& run : trade.runs) {
    const double spacing = run.settings.empty() ? 1e-3 : spacing_of(run);
    EXPECT_NEAR(*run.errors.at("fork.place"), 0.5 * std::abs(spacing - spacing_of(trade.reference)),
                1e-10)
        << name_of(run.settings);
  }
  EXPECT_THAT(text_of(trade), HasSubstr("times coarser"));
  ASSERT_FALSE(trade.recommended.empty());
}

TEST_F(TradeTest, DoesNotScreenWhatIsCheap) {
  EXPECT_EQ(traded(R"({"a": 0.5})", {}, {.costly = 1e6}).screened_at, 1.0);
}

TEST_F(TradeTest, TriesCadencesAndSizesOfMovies) {
  const auto film = folder_.path / "film.mp4";
  write_text(film, std::string(1000, 'x'));
  const Trade trade = traded(fmt::format(R"({{"a": 0.5, "movie": "{}"}})", film.string()));
  ASSERT_EQ(trade.pictures.size(), 7U);
  EXPECT_TRUE(trade.pictures[0].settings.empty());
  EXPECT_EQ(trade.pictures[0].file_bytes, 1000U);
  const PictureCost& densest = trade.pictures[1];
  EXPECT_NEAR(*densest.errors.at("seen.time"), 1e-4 / 400.0, 1e-12);
  EXPECT_NEAR(*densest.errors.at("seen.place"), 0.1 / 1280.0, 1e-12) << "a pixel of a still crack";
  EXPECT_EQ(to_json(trade)["pictures"].size(), 7U);
  EXPECT_THAT(text_of(trade), HasSubstr("seen.place"));
}

TEST_F(TradeTest, TriesNoMoviesWhereThereAreNone) {
  EXPECT_TRUE(traded(R"({"a": 0.5})").pictures.empty());
}

TEST_F(TradeTest, ComparesStiffnessAndTheSpeedOfWaves) {
  const Trade trade = traded(R"({"a": 0.5, "p": 1, "spacing": 1e-3})");
  const double more = 0.5 * (1e-3 - 0.5e-3);  // of the error, than of the reference
  EXPECT_NEAR(*trade.runs[0].errors.at("stiffness"), 70e9 * more, 1.0);
  EXPECT_NEAR(*trade.runs[0].errors.at("wave.speed"), 1e4 * more, 1e-9);
}

TEST_F(TradeTest, SaysWhyTheScriptItselfFails) {
  write_text(folder_.path / "fails", "");
  EXPECT_THROW(traded("{"), Error);
}

TEST_F(TradeTest, TellsProgramsTheSame) {
  const Trade trade = traded(R"({"a": 0.5})");
  const auto json = to_json(trade);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["kind"], "trade");
  EXPECT_TRUE(json["reference"].contains("settings"));
  ASSERT_EQ(json["runs"].size(), trade.runs.size());
  for (const auto& run : json["runs"])
    for (const char* key : {"settings", "wall_s", "cpu_s", "bytes", "errors", "on_front"})
      EXPECT_TRUE(run.contains(key)) << key;
  ASSERT_EQ(json["recommended"].size(), trade.recommended.size());
  EXPECT_EQ(json["recommended"][0]["budget"], trade.recommended[0].budget);
  EXPECT_EQ(table_of(trade).rows.size(), trade.runs.size() + 1);
}

}  // namespace
}  // namespace hackle
