// SPDX-License-Identifier: MIT
#include "output/files/record_options.hpp"

#include <functional>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// 40 x 20 nodes in cells of 0.5 mm, the first at 0.25 mm.
const Lattice& recorded_lattice() {
  static const Lattice lattice(test::bare_plate(40, 20), test::numerics());
  return lattice;
}

RecordContents contents(const RecordOptions& options) {
  return contents_of(options, recorded_lattice());
}

std::string record_refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
  return "";
}

TEST(RecordOptionsOf, AreWhatPicturesNeedWhereNothingIsSaid) {
  const RecordContents all = contents({1e-6});
  EXPECT_THAT(all.fields, ElementsAre("damage", "displacement", "velocity", "bonds"));
  EXPECT_FALSE(all.part);
  EXPECT_EQ(all.nodes.nodes(), 800U);
}

TEST(RecordOptionsOf, ARegionHoldsTheNodesWithinItsBounds) {
  RecordOptions options{1e-6};
  options.region = rectangle({0.25e-3, 0.9e-3}, {1.8e-3, 1.3e-3});
  const NodeWindow nodes = contents(options).nodes;
  EXPECT_EQ(nodes.i, 0);
  EXPECT_EQ(nodes.nx, 4);  // 0.25, 0.75, 1.25, 1.75 mm
  EXPECT_EQ(nodes.j, 2);
  EXPECT_EQ(nodes.ny, 1);  // 1.25 mm
  EXPECT_THAT(contents(options).fields, ElementsAre("damage", "displacement", "velocity"));
}

TEST(RecordOptionsOf, ACoarserGridLeavesAsMuchOutOnBothSides) {
  RecordOptions options{1e-6};
  options.coarsen = 3;
  const NodeWindow nodes = contents(options).nodes;
  EXPECT_EQ(nodes.nx, 14);  // 0, 3, ..., 39
  EXPECT_EQ(nodes.i, 0);
  EXPECT_EQ(nodes.ny, 7);  // 0, 3, ..., 18 of 20: one is left over
  EXPECT_EQ(nodes.j, 0);
  options.coarsen = 7;
  EXPECT_EQ(contents(options).nodes.i, 2);  // 2, 9, ..., 37: two on each side
  EXPECT_EQ(contents(options).nodes.nx, 6);
}

TEST(RecordOptionsOf, AreRefusedWithARemedy) {
  RecordOptions options{1e-6};
  options.fields = {"stres_1"};
  EXPECT_THAT(record_refusal([&] { contents(options); }), HasSubstr("did you mean 'stress_1'?"));
  options.fields = {"bonds"};
  options.coarsen = 2;
  EXPECT_THAT(record_refusal([&] { contents(options); }), HasSubstr("bonds are only recorded"));
  options.fields.clear();
  options.exact = true;
  EXPECT_THAT(record_refusal([&] { contents(options); }), HasSubstr("state of all nodes"));
  options = {1e-6};
  options.region = rectangle({0.03, 0.0}, {0.04, 0.01});
  EXPECT_THAT(record_refusal([&] { contents(options); }), HasSubstr("no node"));
  options = {1e-6};
  options.fields = {"fringes"};
  Plate plate = test::bare_plate(40, 20);
  plate.material.fringe = 0.0;
  const Lattice without(plate, test::numerics());
  EXPECT_THAT(record_refusal([&] { contents_of(options, without); }), HasSubstr("fringe"));
}

TEST(RecordOptionsOf, NeedATimeOrANumberOfSteps) {
  EXPECT_EQ(interval_of({1e-6}, 2e-8), 1e-6);
  EXPECT_EQ(interval_of({{}, 5}, 2e-8), 5 * 2e-8);
  EXPECT_THAT(record_refusal([] { interval_of({}, 2e-8); }), HasSubstr("every = 1*us, or steps"));
  EXPECT_NE(record_refusal([] { interval_of({1e-6, 5}, 2e-8); }), "");
}

}  // namespace
}  // namespace hackle
