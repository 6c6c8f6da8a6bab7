// SPDX-License-Identifier: MIT
// Reads the value of an option by its type. Values that only one noun knows (a material, a marker,
// a recording) are read by the option's own reader, beside the binding of that noun.
#pragma once

#include <any>
#include <cstddef>

#include "console/schema/given_value.hpp"

namespace hackle {

// A value of OptionType::choice: the index of the text among the choices.
struct Choice {
  std::size_t index = 0;
};

// [-0, +0] Returns the value, or nothing after adding a problem. It holds
//   number, integer, flag: double, std::int64_t, bool
//   text, caption: std::string, and texts a vector of those
//   point, pair: Vec2, and points a vector of those
//   window: Eigen::Vector3d
//   numbers: std::vector<double>
//   choice: Choice
//   vector_field, scalar_field, amplitude: VectorField, ScalarField, Amplitude
//   function: LuaFunction
//   any other: the type that the option's own reader returns
std::any read_value(const GivenValue& given);

// [-0, +0] Does so for points: a list of {x, y}, or the name of a file (point_file.hpp).
std::any read_points(const GivenValue& given);

}  // namespace hackle
