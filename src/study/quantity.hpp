// SPDX-License-Identifier: MIT
// What runs of the same plate are compared by: numbers, places, paths and fields, by name.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/vec2.hpp"
#include "study/case.hpp"

namespace hackle {

// How two values of a quantity are compared.
enum class ComparedAs {
  number,  // the difference, in the unit of the quantity
  count,   // the same, of a whole number
  place,   // the distance, m
  paths,   // the Hausdorff distance of the two sets of lines, m
  field,   // the relative difference, L2
};

struct QuantityRow {
  std::string_view name;  // "fork.time"
  ComparedAs kind = ComparedAs::number;
  std::string_view unit;  // SI, of the difference; "" for a pure number
  std::string_view sentence;
  bool is_error = false;  // its value is itself an error: the right one is 0
};

// Returns all of them, in the order of tables. Those of the script's own, expect.NAME, are numbers
// besides.
std::span<const QuantityRow> quantity_rows();
// Returns the row of a name, also of expect.NAME; nothing if there is none.
std::optional<QuantityRow> quantity_named(std::string_view name);
// Returns the names, checked. Throws Error (usage) with the nearest name for each that is none.
std::vector<QuantityRow> quantities_named(const std::vector<std::string>& names);

using Line = std::vector<Vec2>;  // m

// A value; what its kind does not need is empty.
struct QuantityValue {
  std::optional<double> number;
  std::optional<Vec2> place;
  std::vector<Line> paths;
  std::vector<std::optional<Vec2>> field;

  bool found() const { return number || place || !paths.empty() || !field.empty(); }
};

// Returns what a run tells of a quantity (hackle run --json --sample); of several simulations, the
// last. Nothing is found of a run that did not finish.
QuantityValue value_of(const Outcome& outcome, const QuantityRow& row);

// Returns how wrong a value is, compared to that of a reference: their distance, or, of what is
// itself an error, its size.
std::optional<double> error_of(const QuantityValue& value, const QuantityValue& reference,
                               const QuantityRow& row);

// Returns how far two values are apart, in the unit of the row; 0 if neither run found any, nothing
// if only one did.
std::optional<double> distance(const QuantityValue& one, const QuantityValue& other,
                               const QuantityRow& row);

}  // namespace hackle
