// SPDX-License-Identifier: MIT
// How a value of each type of option is read. What only some room knows (a material, a marker, a
// recording) is read by the option's own reader, which stands beside the binding of that noun.
#pragma once

#include <any>
#include <cstddef>

#include "console/schema/given_value.hpp"

namespace hackle {

// A value of OptionType::choice: the place of the text among the choices.
struct Choice {
  std::size_t index = 0;
};

// [-0, +0] The value, or nothing after adding a problem. It holds
//   number, integer, flag: double, std::int64_t, bool
//   text, caption: std::string, and texts a vector of those
//   point, pair: Vec2, and points a vector of those
//   window: Eigen::Vector3d
//   numbers: std::vector<double>
//   choice: Choice
//   vector_field, scalar_field, amplitude, function: VectorField, ScalarField, Amplitude,
//   LuaFunction any other: what the option's own reader says
std::any read_value(const GivenValue& given);

}  // namespace hackle
