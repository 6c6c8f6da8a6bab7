// SPDX-License-Identifier: MIT
#include "study/features.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "study/instruction_count.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

TEST(Features, AreChosenByNameBehindTheBase) {
  EXPECT_EQ(features_named({}).size(), feature_rows().size());
  const auto rows = features_named({"contact", "none", "movie"});
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].name, "none");
  EXPECT_EQ(rows[2].name, "movie");
  try {
    features_named({"contcat"});
    ADD_FAILURE() << "it must be refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'contact'?"));
  }
}

std::vector<FeatureCost> two_costs() {
  FeatureCost plain{.name = "none", .cpu = 1.0, .start_cpu = 0.02, .ns_per_node_step = 30.0};
  FeatureCost more{.name = "contact", .cpu = 1.5, .start_cpu = 0.02, .ns_per_node_step = 45.0};
  more.bytes = 2'000'000;
  more.inside = {"alpha"};
  return {plain, more};
}

TEST(Features, AreToldAgainstTheFirst) {
  const std::string text = text_of(two_costs());
  EXPECT_THAT(text, testing::AllOf(HasSubstr("contact"), HasSubstr("1.50"), HasSubstr("2.0"),
                                   HasSubstr("contact: the kernel has alpha"),
                                   testing::Not(HasSubstr("instr."))));
  auto counted = two_costs();
  counted[0].instructions = 100.0;
  counted[1].instructions = 125.0;
  EXPECT_THAT(text_of(counted), testing::AllOf(HasSubstr("instr."), HasSubstr("1.2500")));
}

TEST(Features, SayWhichTouchMemoryAtTheStart) {
  auto costs = two_costs();
  costs[1].start_bytes = 100'000;
  EXPECT_THAT(text_of(costs), HasSubstr("Start-up: 1 of 1 features touch less than 0.5 MB"));
  costs[1].start_bytes = 3'000'000;
  EXPECT_THAT(text_of(costs), HasSubstr("contact 3.0 MB."));
  EXPECT_EQ(to_json(costs)["features"][1]["start_bytes"], 3'000'000);
}

TEST(Features, AreJsonWithTheKeysThatArePromised) {
  const auto json = to_json(two_costs());
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["kind"], "features");
  const auto& one = json["features"][1];
  EXPECT_EQ(one["name"], "contact");
  EXPECT_EQ(one["cpu_s"], 1.5);
  EXPECT_EQ(one["bytes"], 2'000'000);
  EXPECT_EQ(one["ns_per_node_step"], 45.0);
  EXPECT_TRUE(one["instructions_per_node_step"].is_null());
}

TEST(InstructionCount, IsReadFromTheReportOfCallgrind) {
  EXPECT_EQ(collected_in("==12== Events    : Ir\n==12== Collected : 123456\n==12== \n"), 123456.0);
  EXPECT_EQ(collected_in("valgrind: no such file"), std::nullopt);
}

}  // namespace
}  // namespace hackle
