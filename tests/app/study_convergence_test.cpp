// SPDX-License-Identifier: MIT
// hackle study convergence, as a user meets it.
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/study_plate.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

using StudyConvergenceTest = test::StudiedPlate;

TEST_F(StudyConvergenceTest, SaysWhatConverges) {
  const test::Ended ended = study("convergence", {"--set", "time=8us"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  for (const char* words : {"delta: ", "m = 3", "step: ", "settled by every refinement: "})
    EXPECT_THAT(ended.out, HasSubstr(words));
  for (const char* name :
       {"convergence.json", "convergence.csv", "delta-error.png", "m-error.png", "step-error.png"})
    EXPECT_TRUE(exists(name)) << name;
  // From what is kept: the same words.
  EXPECT_EQ(study("convergence", {"--set", "time=8us"}).out, ended.out);
}

// Before anything breaks, an elastic plate: displacements converge with the horizon.
TEST_F(StudyConvergenceTest, OfAnElasticPlate) {
  const Json json = told("convergence", {"--set", "load=1MPa", "--set", "time=8us", "--for",
                                         "displacement", "--by", "delta,step"});
  ASSERT_EQ(json["axes"].size(), 2U);
  for (const Json& axis : json["axes"]) {
    const Json& field = axis["quantities"]["displacement"];
    EXPECT_EQ(field["verdict"], "converges");
    EXPECT_LT(field["values"][1], field["values"][0]);
    EXPECT_LT(field["gci"].get<double>(), 0.1);
  }
  // The horizon of the nofail zones follows that of the lattice.
  EXPECT_EQ(json["axes"][0]["levels"][0]["settings"]["horizon"],
            json["axes"][0]["levels"][0]["settings"]["simulate.horizon"]);
}

}  // namespace
}  // namespace hackle
