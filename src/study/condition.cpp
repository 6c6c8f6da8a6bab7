// SPDX-License-Identifier: MIT
#include "study/condition.hpp"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "base/error.hpp"
#include "study/parameter.hpp"

namespace hackle {
namespace {

constexpr std::string_view example = "as in 'branches >= 2' or 'fork.time < 20us'";

std::string_view without_blanks(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

}  // namespace

bool Condition::holds(const Outcome& outcome) const {
  const auto number = value_of(outcome, row).number;
  if (!number) return false;
  switch (comparison) {
    case Comparison::less:
      return *number < value;
    case Comparison::at_most:
      return *number <= value;
    case Comparison::greater:
      return *number > value;
    case Comparison::at_least:
      return *number >= value;
    default:
      return *number == value;
  }
}

Condition condition_of(std::string_view text) {
  const auto refuse = [&](std::string_view what) {
    throw Error(ErrorKind::usage, fmt::format("the condition '{}' {}", text, what),
                std::string(example));
  };
  const std::size_t from = std::min(text.find_first_of("<>="), text.size());
  const std::size_t to = std::min(text.find_first_not_of("<>=", from), text.size());
  const auto comparison = value_named<Comparison>(text.substr(from, to - from));
  if (!comparison) refuse("has no comparison <, <=, >, >= or ==");
  const std::string name(without_blanks(text.substr(0, from)));
  const QuantityRow row = quantities_named({name}).front();
  if (row.kind != ComparedAs::number && row.kind != ComparedAs::count)
    refuse(fmt::format("compares {}, which is no number", name));
  const auto value = measure_of(text.substr(to));
  if (!value) refuse("does not end with a number and its unit");
  return {row, *comparison, value->value(), std::string(text)};
}

}  // namespace hackle
