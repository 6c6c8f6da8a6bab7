// SPDX-License-Identifier: MIT
// What a row of ever finer solutions tells: whether they converge, how fast, to what, and how far
// the finest still is from it.
// Sources: Roache, J. Fluids Eng. 116 (1994) 405; Celik et al., J. Fluids Eng. 130 (2008) 078001
// for ratios that differ; ASME V&V 20-2009; bounds of p after Oberkampf and Roy (2010), 8.6.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "base/described.hpp"

namespace hackle {

// missing: the quantity was not found at every level; unknown: there are fewer than three.
enum class Trend { converges, oscillates, diverges, constant, missing, unknown };
template <>
inline constexpr auto enum_names<Trend> =
    std::to_array<std::string_view>({"converges", "oscillates", "diverges", "does not change",
                                     "not found in all", "too few levels"});

// From one level to the next finer one.
struct LevelChange {
  double size = 0.0;  // how far the values are apart, at least 0
  int sign = 1;       // of a number; 1 for what has none, as a distance of places
};

struct ObservedOrder {
  Trend trend = Trend::unknown;
  std::optional<double> order;  // p of f = f0 + C h^p; of three levels that do not oscillate
  // The error of the finest level, in the unit of the changes, times the factor of safety: 1.25;
  // 3 with p = 1 for two levels. There is none for what diverges.
  std::optional<double> uncertainty;
  std::optional<double> per_halving;  // size of the last change, scaled to a step of factor 2
};

// `sizes` are those of the spacing, m, or of whatever else is refined, from coarse to fine, each
// smaller than the one before; `changes` between them, one less; `resolutions` what each level can
// tell apart, empty for exact values. The finest three decide. Changes that neither of their levels
// can tell from none are none. A change that does not shrink, p below 0.1, diverges. The
// uncertainty is at least that of the finest resolution.
ObservedOrder observed_order(std::span<const double> sizes, std::span<const LevelChange> changes,
                             std::span<const double> resolutions = {});

// Returns f0, the value for size 0, after Richardson: of the finest value `fine`, the one before,
// and p above 0.
double richardson(double coarse, double fine, double ratio, double order);

// Returns the exponent q of the best f = C h^q, by least squares of the logarithms; nothing unless
// all are above 0 and there are two or more.
std::optional<double> fitted_exponent(std::span<const double> sizes,
                                      std::span<const double> values);

}  // namespace hackle
