// SPDX-License-Identifier: MIT
#include "base/described.hpp"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>

namespace hackle {

enum class Colour { red, green };
template <>
inline constexpr auto enum_names<Colour> = std::to_array<std::string_view>({"red", "green"});

struct Thing {
  enum class Kind { long_one, heavy_one };
  double size = 0.0;
  Kind kind = Kind::long_one;
  double amount = 0.0;
};
template <>
inline constexpr auto description_of<Thing> = describe_noun(
    "thing", "thing", member("size", &Thing::size, {.unit = "m"}),
    kind_member(&Thing::kind, &Thing::amount, std::to_array<std::string_view>({"length", "weight"}),
                std::to_array<About>({{.unit = "m"}, {.unit = "kg"}})));

namespace {

TEST(Range, HoldsItsEndsOrNot) {
  EXPECT_TRUE(between(1.0, 2.0).holds(1.0) && between(1.0, 2.0).holds(2.0));
  EXPECT_FALSE(above(1.0).holds(1.0) || from_to_below(0.0, 1.0).holds(1.0));
  EXPECT_TRUE(above(1.0).holds(1.1) && from_to_below(0.0, 1.0).holds(0.0));
  EXPECT_FALSE(strictly_between(0.0, 1.0).holds(0.0) || strictly_between(0.0, 1.0).holds(1.0));
  EXPECT_FALSE(above_up_to(0.0, 1.0).holds(0.0));
  EXPECT_TRUE(above_up_to(0.0, 1.0).holds(1.0));
  for (const Range& range : {Range{}, above(0.0), at_least(0.0), between(-1.0, 1.0)})
    EXPECT_FALSE(range.holds(std::nan("")));
}

TEST(Range, SaysItsEnds) {
  EXPECT_EQ(range_text({}, "m"), "");
  EXPECT_EQ(range_text(between(320.0, 7680.0), "px"), "between 320 and 7680 px");
  EXPECT_EQ(range_text(above(0.0), "m"), "above 0 m");
  EXPECT_EQ(range_text(at_least(2.0), ""), "at least 2");
  EXPECT_EQ(range_text({.max = 3.0}, "s"), "at most 3 s");
  EXPECT_EQ(range_text(above_up_to(0.0, 100.0), ""), "above 0 and at most 100");
  EXPECT_EQ(range_text(from_to_below(0.0, 1.0), ""), "at least 0 and below 1");
  EXPECT_EQ(range_text(strictly_between(-1.0, 0.5), ""), "above -1 and below 0.5");
}

TEST(Objection, NamesNounMemberValueUnitAndBound) {
  EXPECT_EQ(objection("hole", "radius", -1e-3, "m", above(0.0)),
            "hole: radius is -1 mm, it must be above 0 m");
  EXPECT_EQ(objection("hole", "radius", NAN, "m", above(0.0)),
            "hole: radius is nan, expected a finite number in m");
  EXPECT_EQ(objection("hole", "count", INFINITY, "", {}),
            "hole: count is inf, expected a finite number");
  EXPECT_EQ(objection("hole", "radius", 1.0, "m", above(0.0)), std::nullopt);
}

TEST(Described, MembersAreVisitedInOrder) {
  std::vector<std::string_view> names;
  for_each_member<Thing>([&](const auto& member) {
    if constexpr (requires { member.kind; })
      names.insert(names.end(), member.names.begin(), member.names.end());
    else
      names.push_back(member.name);
  });
  EXPECT_THAT(names, testing::ElementsAre("size", "length", "weight"));
  static_assert(Described<Thing> && !Described<int>);
}

TEST(EnumNames, LeadThereAndBack) {
  EXPECT_EQ(name_of(Colour::green), "green");
  EXPECT_EQ(value_named<Colour>("red"), Colour::red);
  EXPECT_EQ(value_named<Colour>("blue"), std::nullopt);
}

}  // namespace
}  // namespace hackle
