// SPDX-License-Identifier: MIT
#include "study/quantity.hpp"

#include <cmath>
#include <set>

#include <gmock/gmock.h>

#include "base/error.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

Outcome told(const char* json) {
  Outcome outcome;
  outcome.state = CaseState::finished;
  outcome.told = nlohmann::ordered_json::parse(json);
  return outcome;
}

double number_of(const Outcome& outcome, const char* name) {
  return value_of(outcome, *quantity_named(name)).number.value_or(std::nan(""));
}

const char* const branched = R"({
  "residual_share": -0.02,
  "energy_J_per_m": {"broken": 3.5},
  "first_break": {"time_s": 2e-6, "place_m": [0.05, 0.02]},
  "events": [
    {"kind": "nucleation", "time_s": 1e-6, "place_m": [0, 0]},
    {"kind": "branch", "place_m": [9, 9]},
    {"kind": "branch", "time_s": 5e-6, "place_m": [0.06, 0.02], "angle_rad": 1.1},
    {"kind": "branch", "time_s": 7e-6, "place_m": [0.08, 0.02], "angle_rad": 0.2},
    {"kind": "arrival", "time_s": 9e-6, "place_m": [0.1, 0.03]}],
  "graph": {
    "cracks": [
      {"initial": true, "length_m": 0.05, "points_m": [[0, 0.02], [0.05, 0.02]]},
      {"initial": false, "length_m": 0.01, "max_speed_m_per_s": 900, "points_m": [[0.05, 0.02], [0.06, 0.02]]},
      {"initial": false, "length_m": 0.02, "max_speed_m_per_s": 1200, "points_m": [[0.06, 0.02], [0.07, 0.03]]}],
    "tips": [{"state": "running"}, {"state": "arrived"}, {"state": "joined"}, {"state": "initial"}]},
  "sample": {"displacements_m": [[1, 0], null, [0, 2]]},
  "expectations": [{"quantity": "height of it", "got": 4.5}, {"quantity": "lost", "got": null}]})";

TEST(StudyQuantity, IsReadFromWhatARunTells) {
  const Outcome outcome = told(branched);
  EXPECT_EQ(number_of(outcome, "first_bond.time"), 2e-6);
  EXPECT_EQ(number_of(outcome, "fork.time"), 5e-6) << "an undated one came before the run";
  EXPECT_EQ(number_of(outcome, "fork.angle"), 1.1);
  EXPECT_EQ(number_of(outcome, "arrival.time"), 9e-6);
  EXPECT_EQ(number_of(outcome, "branches"), 2);
  EXPECT_DOUBLE_EQ(number_of(outcome, "crack.length"), 0.03);
  EXPECT_EQ(number_of(outcome, "tip.speed"), 1200);
  EXPECT_EQ(number_of(outcome, "energy.broken"), 3.5);
  EXPECT_EQ(number_of(outcome, "residual"), -0.02);
  EXPECT_EQ(number_of(outcome, "expect.height of it"), 4.5);
  EXPECT_EQ(value_of(outcome, *quantity_named("fork.place")).place, Vec2(0.06, 0.02));
  EXPECT_EQ(value_of(outcome, *quantity_named("tip.path")).paths.size(), 2U);
  EXPECT_EQ(value_of(outcome, *quantity_named("displacement")).field.size(), 3U);
}

TEST(StudyQuantity, IsNotFoundWhereNothingHappened) {
  const Outcome quiet = told(R"({"residual_share": 0})");
  std::set<std::string_view> found;
  for (const QuantityRow& row : quantity_rows())
    if (value_of(quiet, row).found()) found.insert(row.name);
  EXPECT_THAT(found, testing::ElementsAre("branches", "crack.length", "residual"));
  EXPECT_FALSE(value_of(told(branched), *quantity_named("expect.lost")).found());
  EXPECT_FALSE(value_of(Outcome{}, *quantity_named("branches")).found());
}

TEST(StudyQuantity, ComparesByItsKind) {
  const QuantityRow place = *quantity_named("fork.place"), field = *quantity_named("displacement"),
                    time = *quantity_named("fork.time");
  EXPECT_DOUBLE_EQ(*distance({.place = Vec2(0, 0)}, {.place = Vec2(3, 4)}, place), 5.0);
  EXPECT_DOUBLE_EQ(*distance({.number = 1.0}, {.number = -2.0}, time), 3.0);
  const QuantityValue one{.field = {Vec2(1, 0), std::nullopt, Vec2(7, 7)}},
      other{.field = {Vec2(1, 1), Vec2(5, 5), std::nullopt}};
  EXPECT_DOUBLE_EQ(*distance(one, other, field), 1.0 / std::sqrt(2.0)) << "where both have a value";
  EXPECT_EQ(distance({}, {}, place), 0.0);
  EXPECT_EQ(distance({.place = Vec2(0, 0)}, {}, place), std::nullopt);
}

TEST(StudyQuantity, WhatIsItselfAnErrorNeedsNoReference) {
  const QuantityRow residual = *quantity_named("residual");
  EXPECT_DOUBLE_EQ(*error_of({.number = -0.03}, {.number = -0.03}, residual), 0.03);
}

TEST(StudyQuantity, UnknownNamesAreToldAllAtOnce) {
  try {
    quantities_named({"fork.tme", "branches", "tip"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_THAT(error.what(), HasSubstr("'fork.tme' (did you mean 'fork.time'?)"));
    EXPECT_THAT(error.what(), HasSubstr("'tip'"));
  }
  EXPECT_EQ(quantities_named({"tip.path", "expect.place of it"}).size(), 2U);
}

}  // namespace
}  // namespace hackle
