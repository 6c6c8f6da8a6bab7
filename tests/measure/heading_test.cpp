// SPDX-License-Identifier: MIT
#include "measure/heading.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "measure/node_value.hpp"
#include "measure/quantity.hpp"
#include "measure/scalar.hpp"

namespace hackle {
namespace {

void expect_read_back(const std::string& name, std::string_view unit) {
  const std::string heading = heading_of(name, unit);
  EXPECT_EQ(unit_in_heading(heading, name), std::string(unit)) << heading;
  EXPECT_EQ(unit_in_heading(heading, heading), std::string(unit)) << heading;
  std::string plain = name;
  std::ranges::replace(plain, '.', '_');
  EXPECT_EQ(name_in_heading(heading), plain) << heading;
}

TEST(Heading, EveryColumnIsReadBack) {
  for (const Quantity& one : quantities()) expect_read_back(std::string(one.name), one.unit);
  for (const PartQuantity& one : load_quantities())
    expect_read_back(fmt::format("grip.{}", one.name), one.unit);
  for (const PartQuantity& how : field_quantities())
    for (const Scalar& field : scalars())
      expect_read_back(fmt::format("{}.{}", how.name, field.name), field.unit);
}

TEST(Heading, NamesAreIdentifiers) {
  EXPECT_EQ(heading_of("tip.x", "m"), "tip_x_m");
  EXPECT_EQ(heading_of("tip.speed", "m/s"), "tip_speed_m_per_s");
  EXPECT_EQ(heading_of("max.energy_density", "J/m3"), "max_energy_density_J_per_m3");
  EXPECT_EQ(heading_of("bonds", ""), "bonds");
}

TEST(Heading, AnotherColumnIsNotTaken) {
  EXPECT_EQ(unit_in_heading("tip_x_m", "tip"), std::nullopt);
  EXPECT_EQ(unit_in_heading("tip_x_m", "x"), std::nullopt);
  EXPECT_EQ(unit_in_heading("tip_speed_m_per_s", "tip.speed_m"), std::nullopt);
  EXPECT_EQ(unit_in_heading("m", "m"), "");
  EXPECT_EQ(name_in_heading("_m"), "_m");
}

}  // namespace
}  // namespace hackle
