// SPDX-License-Identifier: MIT
#include "output/report/expectation.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace hackle {
namespace {

Expectation fork() {
  Expectation e;
  e.name = "borden";
  e.quantity = "fork";
  e.unit = "m";
  e.expected = 67e-3;
  e.tolerance = 1e-3;
  e.got = 67.5e-3;
  e.source = "paper";
  return e;
}

TEST(Expectation, PassesWithinItsTolerance) {
  Expectation e = fork();
  EXPECT_EQ(e.verdict(), Verdict::pass);
  EXPECT_NEAR(e.deviation().value(), 0.5, 1e-12);
  e.got = 68.1e-3;
  EXPECT_EQ(e.verdict(), Verdict::fail);
  e.got = 65.9e-3;
  EXPECT_EQ(e.verdict(), Verdict::fail);
  e.got.reset();
  EXPECT_EQ(e.verdict(), Verdict::fail);
  EXPECT_FALSE(e.deviation());
  e.unsupported = true;
  EXPECT_EQ(e.verdict(), Verdict::unsupported);
}

TEST(Expectation, PassesWithinBoundsOfEitherSide) {
  Expectation e = fork();
  e.expected.reset();
  e.min = 60e-3;
  EXPECT_EQ(e.verdict(), Verdict::pass);
  EXPECT_EQ(expected_text(e), "at least 60 mm");
  e.max = 67e-3;
  EXPECT_EQ(e.verdict(), Verdict::fail);
  EXPECT_EQ(expected_text(e), "60 mm to 67 mm");
  EXPECT_NEAR(e.deviation().value(), 4.0 / 3.5, 1e-12);
  e.min = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(expected_text(e), "at most 67 mm");
}

TEST(Expectation, IsOneLine) {
  Expectation e = fork();
  e.reason = "coarse";
  EXPECT_EQ(line_of(e), "pass  fork: 67.5 mm, expected 67 mm within 1 mm (paper)");
  e.got = 70e-3;
  e.confirmed = false;
  EXPECT_EQ(line_of(e),
            "fail  fork: 70 mm, expected 67 mm within 1 mm (paper (unconfirmed)): coarse");
  e.relative = 0.02;
  EXPECT_EQ(tolerance_text(e), "2 %");
  e.relative = e.tolerance = 0.0;
  EXPECT_EQ(tolerance_text(e), "exact");
  e.got.reset();
  EXPECT_EQ(got_text(e), "nothing");
  e.unsupported = true;
  EXPECT_EQ(line_of(e), "unsupported  fork (paper (unconfirmed)): coarse");
}

TEST(Expectation, HasTheKeysOfTheSchema) {
  Expectation e = fork();
  e.confirmed = false;
  e.reason = "why";
  const auto json = to_json(e);
  EXPECT_EQ(json["name"], "borden");
  EXPECT_EQ(json["quantity"], "fork");
  EXPECT_EQ(json["unit"], "m");
  EXPECT_EQ(json["expected"], 67e-3);
  EXPECT_EQ(json["tolerance"], 1e-3);
  EXPECT_EQ(json["got"], 67.5e-3);
  EXPECT_EQ(json["source"], "paper");
  EXPECT_EQ(json["verdict"], "pass");
  EXPECT_EQ(json["confirmed"], false);
  EXPECT_EQ(json["reason"], "why");
  EXPECT_NEAR(json["min"].get<double>(), 66e-3, 1e-15);
  EXPECT_NEAR(json["max"].get<double>(), 68e-3, 1e-15);
  EXPECT_FALSE(json.contains("curve"));
  e.expected.reset();
  e.got.reset();
  e.min = 2.0;
  const auto bounds = to_json(e);
  for (const char* key : {"expected", "tolerance", "got", "max"})
    EXPECT_TRUE(bounds[key].is_null()) << key;
  EXPECT_EQ(bounds["min"], 2.0);
}

TEST(Expectation, TellsItsCurve) {
  Expectation e = fork();
  e.curve = {"x", {1, 2}, {3, 4}, {5, std::nan("")}};
  EXPECT_EQ(to_json(e)["curve"].dump(),
            R"({"along":"x","x":[1.0,2.0],"expected":[3.0,4.0],"got":[5.0,null]})");
}

}  // namespace
}  // namespace hackle
