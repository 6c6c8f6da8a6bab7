// SPDX-License-Identifier: MIT
#include "output/picture/automatic_range.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>

#include "output/picture/field_choice.hpp"

namespace hackle {
namespace {

constexpr unsigned dropped_bits = 14;  // of 32: sign, exponent and nine bits of the mantissa remain
constexpr std::size_t bins = std::size_t{1} << (32U - dropped_bits);
constexpr std::array<std::string_view, 2> diverging{"roma", "vik"};

// Increases with the value, for both signs.
std::uint32_t rank_of(float value) {
  constexpr std::uint32_t sign = 0x80000000U;
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

float value_of(std::uint32_t rank) {
  constexpr std::uint32_t sign = 0x80000000U;
  return std::bit_cast<float>((rank & sign) != 0 ? rank & ~sign : ~rank);
}

bool diverge(std::string_view colours) {
  return std::ranges::find(diverging, colours) != diverging.end();
}

}  // namespace

AutomaticRange::AutomaticRange(const PictureOptions& options)
    : options_(options), counts_(bins), min_(std::numeric_limits<double>::infinity()), max_(-min_) {
}

void AutomaticRange::add(const View& view) {
  const bool positive = is_logarithmic(options_);
  if (values_ == 0) usual_ = usual_ends(options_, view);
  for (const float value : field_values(options_, view)) {
    if (!std::isfinite(value) || (positive && value <= 0.0F)) continue;
    ++counts_[rank_of(value) >> dropped_bits];
    ++values_;
    min_ = std::min(min_, static_cast<double>(value));
    max_ = std::max(max_, static_cast<double>(value));
  }
}

// Returns the value below which this share of the values lies.
double AutomaticRange::value_at(double share) const {
  const double wanted = share * static_cast<double>(values_);
  std::int64_t below = 0;
  for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
    below += counts_[bin];
    if (counts_[bin] == 0 || static_cast<double>(below) < wanted) continue;
    const auto rank = static_cast<std::uint32_t>(bin << dropped_bits) + (1U << (dropped_bits - 1));
    return std::clamp(static_cast<double>(value_of(rank)), min_, max_);
  }
  return max_;
}

// Returns the middle value of diverging colours.
std::optional<double> AutomaticRange::middle() const {
  const Scalar& scalar = scalar_of(options_.field);
  if (!diverge(options_.colours.empty() ? scalar.colours : options_.colours)) return std::nullopt;
  return diverge(scalar.colours) ? 0.5 * (usual_.min + usual_.max) : 0.0;
}

Ends AutomaticRange::ends() const {
  if (values_ == 0) return usual_;
  const double outside = 0.5 * (1.0 - 0.01 * options_.percentile.value_or(100.0));
  Ends ends = outside > 0.0 ? Ends{value_at(outside), value_at(1.0 - outside)} : Ends{min_, max_};
  if (const std::optional<double> centre = middle(); centre && !is_logarithmic(options_)) {
    const double reach = std::max(*centre - ends.min, ends.max - *centre);
    ends = {*centre - reach, *centre + reach};
  }
  return ends.min < ends.max ? ends : usual_;
}

Ends automatic_range(const PictureOptions& options, const View& view) {
  AutomaticRange range(options);
  range.add(view);
  return range.ends();
}

}  // namespace hackle
