// SPDX-License-Identifier: MIT
#include "study/trade_score.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hackle {

Errors errors_of(const Outcome& outcome, const Outcome& reference,
                 const std::vector<QuantityRow>& rows) {
  Errors errors;
  for (const QuantityRow& row : rows) {
    const QuantityValue value = value_of(outcome, row), right = value_of(reference, row);
    if (value.found() || right.found()) errors[std::string(row.name)] = error_of(value, right, row);
  }
  return errors;
}

double allowed_error(const QuantityRow& row, const SceneNumerics& scene, const Outcome& reference) {
  constexpr double percent = 0.01, five_degrees = std::numbers::pi / 36.0;
  if (row.kind == ComparedAs::place || row.kind == ComparedAs::paths) return scene.horizon;
  if (row.kind == ComparedAs::field || row.is_error) return percent;
  if (row.kind == ComparedAs::count) return 1.0;
  if (row.unit == "m") return scene.horizon;
  if (row.unit == "s") return percent * scene.duration;
  if (row.unit == "rad") return five_degrees;
  const double size = 5.0 * percent * std::abs(value_of(reference, row).number.value_or(0.0));
  return size > 0.0 ? size : 1.0;
}

double score(const Errors& errors, const std::map<std::string, double>& allowed) {
  constexpr double worst = 10.0;
  if (errors.empty()) return 0.0;
  double sum = 0.0;
  for (const auto& [name, error] : errors) {
    const double share = error ? std::min(*error / allowed.at(name), worst) : worst;
    sum += share * share;
  }
  return std::sqrt(sum / static_cast<double>(errors.size()));
}

}  // namespace hackle
