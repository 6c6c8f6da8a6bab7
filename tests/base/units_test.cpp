// SPDX-License-Identifier: MIT
#include "base/units.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace hackle {
namespace {

TEST(Quantity, TakesThePrefixPeopleUse) {
  EXPECT_EQ(quantity(5e-4, "m"), "0.5 mm");
  EXPECT_EQ(quantity(0.1, "m"), "100 mm");
  EXPECT_EQ(quantity(2.5, "m"), "2.5 m");
  EXPECT_EQ(quantity(3e-6, "m"), "3 um");
  EXPECT_EQ(quantity(209e-9, "s"), "209 ns");
  EXPECT_EQ(quantity(32e-6, "s"), "32 us");
  EXPECT_EQ(quantity(12e6, "Pa"), "12 MPa");
  EXPECT_EQ(quantity(65e9, "Pa"), "65 GPa");
  EXPECT_EQ(quantity(-12e6, "Pa"), "-12 MPa");
  EXPECT_EQ(quantity(8.59e9, "B"), "8.59 GB");
}

TEST(Quantity, LeavesOtherUnitsAlone) {
  EXPECT_EQ(quantity(2235.0, "kg/m3"), "2235 kg/m3");
  EXPECT_EQ(quantity(204.0, "J/m2"), "204 J/m2");
  EXPECT_EQ(quantity(0.317, ""), "0.317");
}

TEST(Quantity, HandlesZeroAndWhatIsNoNumber) {
  EXPECT_EQ(quantity(0.0, "m"), "0 m");
  EXPECT_EQ(quantity(std::nan(""), "s"), "nan s");
  EXPECT_EQ(quantity(std::numeric_limits<double>::infinity(), "Pa"), "inf Pa");
}

TEST(Quantity, NeverRoundsUpToAThousand) {
  for (double value = 1e-9; value < 1.0; value *= 1.0003)
    EXPECT_EQ(quantity(value, "s").find("1000 "), std::string::npos) << value;
}

TEST(Grouped, SeparatesThousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(16000), "16 000");
  EXPECT_EQ(grouped(-1234567), "-1 234 567");
}

TEST(Shortest, ReadsBackAsTheSameNumber) {
  for (const double value : {0.1, 1.0 / 3.0, 1e300, 204.0})
    EXPECT_EQ(std::stod(shortest(value)), value);
}

TEST(Units, HaveDistinctNamesAndPositiveSizes) {
  std::set<std::string_view> names;
  for (const Unit& unit : units()) {
    EXPECT_TRUE(names.insert(unit.name).second) << unit.name;
    EXPECT_GT(unit.factor, 0.0);
  }
  EXPECT_TRUE(names.contains("mm") && names.contains("us") && names.contains("MPa"));
}

// The units that a script may write after a number.
TEST(Units, AreThoseOfSI) {
  const std::map<std::string_view, double> sizes{{"m", 1.0},
                                                 {"cm", 1e-2},
                                                 {"mm", 1e-3},
                                                 {"um", 1e-6},
                                                 {"nm", 1e-9},
                                                 {"s", 1.0},
                                                 {"ms", 1e-3},
                                                 {"us", 1e-6},
                                                 {"ns", 1e-9},
                                                 {"Pa", 1.0},
                                                 {"kPa", 1e3},
                                                 {"MPa", 1e6},
                                                 {"GPa", 1e9},
                                                 {"kg", 1.0},
                                                 {"g", 1e-3},
                                                 {"N", 1.0},
                                                 {"kN", 1e3},
                                                 {"J", 1.0},
                                                 {"deg", std::numbers::pi / 180.0}};
  ASSERT_EQ(units().size(), sizes.size());
  for (const Unit& unit : units()) EXPECT_DOUBLE_EQ(unit.factor, sizes.at(unit.name)) << unit.name;
}

// The number times its prefix must equal the original number.
TEST(Prefixed, IsTheNumberAgain) {
  const std::map<char, double> factors{{'T', 1e12}, {'G', 1e9},  {'M', 1e6},  {'k', 1e3},
                                       {'m', 1e-3}, {'u', 1e-6}, {'n', 1e-9}, {'p', 1e-12}};
  for (const std::string unit : {"m", "s", "Pa", "J", "J/m3", "B", "m/s"})
    for (double size = 1e-14; size < 1e14; size *= 10.0) {
      const PrefixedUnit found = prefixed(size, unit);
      const double factor = found.name == unit ? 1.0 : factors.at(found.name.front());
      EXPECT_DOUBLE_EQ(found.factor, factor) << found.name << ' ' << size;
    }
}

}  // namespace
}  // namespace hackle
