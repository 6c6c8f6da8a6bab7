// SPDX-License-Identifier: MIT
#include "study/parameter.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "base/error.hpp"

namespace hackle {
namespace {

using testing::ElementsAre;

std::vector<std::string> texts_of(const Parameter& parameter) {
  std::vector<std::string> texts;
  for (const ParameterValue& value : parameter.values) texts.push_back(value.text);
  return texts;
}

TEST(Parameter, ReadsARange) {
  const Parameter load = parameter_of("load=6:24:6MPa");
  EXPECT_EQ(load.key, "load");
  EXPECT_THAT(texts_of(load), ElementsAre("6MPa", "12MPa", "18MPa", "24MPa"));
  EXPECT_DOUBLE_EQ(*load.values[1].number, 12e6);
  EXPECT_EQ(load.unit, "Pa");
  EXPECT_TRUE(load.varies());
}

TEST(Parameter, CountsStepsWithoutRounding) {
  EXPECT_THAT(texts_of(parameter_of("x=0:0.3:0.1")), ElementsAre("0", "0.1", "0.2", "0.3"));
  EXPECT_THAT(texts_of(parameter_of("x=3:1:1")), ElementsAre("3", "2", "1"));
  EXPECT_THAT(texts_of(parameter_of("x=0:1:0.4")), ElementsAre("0", "0.4", "0.8"));
  EXPECT_THAT(texts_of(parameter_of("w=500um:1mm:0.25mm")), ElementsAre("0.5mm", "0.75mm", "1mm"));
}

TEST(Parameter, ReadsAList) {
  EXPECT_THAT(texts_of(parameter_of("m=3,4,6")), ElementsAre("3", "4", "6"));
  EXPECT_THAT(texts_of(parameter_of("d=1,2mm")), ElementsAre("1mm", "2mm"));
  const Parameter names = parameter_of("simulate.precision=f32,f64");
  EXPECT_THAT(texts_of(names), ElementsAre("f32", "f64"));
  EXPECT_FALSE(names.values[0].number);
}

TEST(Parameter, TakesAPairAndAListInBracesForOneValue) {
  EXPECT_THAT(texts_of(parameter_of("range=0:12MPa")), ElementsAre("0:12MPa"));
  EXPECT_THAT(texts_of(parameter_of("at={1,2}")), ElementsAre("{1,2}"));
  EXPECT_FALSE(parameter_of("load=12MPa").varies());
  EXPECT_THAT(texts_of(parameter_of("load=12*MPa")), ElementsAre("12*MPa"));
}

TEST(Parameter, TakesTwoEndsForARangeWhereAsked) {
  const Parameter load = ranged_parameter_of("load=6:24MPa");
  ASSERT_TRUE(load.range);
  EXPECT_TRUE(load.values.empty());
  EXPECT_DOUBLE_EQ(load.range->from * load.range->factor, 6e6);
  EXPECT_THROW(ranged_parameter_of("load=6MPa"), Error);
}

TEST(Parameter, KnowsProductsOfUnits) {
  const Parameter tough = ranged_parameter_of("material.G0=100:400J/m2");
  EXPECT_EQ(tough.range->text(250), "250");
  EXPECT_EQ(tough.unit, "J/m2");
  EXPECT_DOUBLE_EQ(measure_of("2N/mm")->value(), 2000.0);
  EXPECT_DOUBLE_EQ(measure_of("3 mm^2")->value(), 3e-6);
  EXPECT_FALSE(measure_of("3 furlongs"));
  EXPECT_FALSE(measure_of("fast"));
}

TEST(Parameter, RefusesWhatLeadsNowhere) {
  for (const char* word : {"load", "=3", "load=", "load=6:24:0MPa", "load=6:6:1MPa",
                           "load=6:24:2furlongs", "load=6mm:24mm:1MPa", "n=0:1e9:1"})
    EXPECT_THROW(parameter_of(word), Error) << word;
}

TEST(Combinations, AreAllOfThem) {
  const std::vector<Settings> all =
      combinations({parameter_of("a=1,2"), parameter_of("b=x"), parameter_of("c=3,4,5")});
  ASSERT_EQ(all.size(), 6U);
  EXPECT_EQ(all[0], (Settings{{"a", "1"}, {"b", "x"}, {"c", "3"}}));
  EXPECT_EQ(all[1].at("c"), "4");
  EXPECT_EQ(all[5], (Settings{{"a", "2"}, {"b", "x"}, {"c", "5"}}));
  EXPECT_THROW(combinations({parameter_of("a=1:200:1"), parameter_of("b=1:200:1")}), Error);
}

}  // namespace
}  // namespace hackle
