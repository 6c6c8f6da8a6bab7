// SPDX-License-Identifier: MIT
// How a load changes in time.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/described.hpp"
#include "base/error.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// A factor of time: 1 for ever, straight lines between given moments, or any function.
class Amplitude {
 public:
  Amplitude() = default;
  // (t in s, factor), t ascending; two of the same t are a jump, to the second at t itself. Before
  // the first and after the last the factor stays.
  explicit Amplitude(std::vector<Vec2> points);
  // Called with t in s. It may throw Error; `text` says what it is.
  Amplitude(std::function<double(double)> function, std::string text);

  bool is_constant() const { return points_.empty() && !function_; }
  bool is_function() const { return static_cast<bool>(function_); }
  const std::vector<Vec2>& points() const { return points_; }

  // Throws Error (refused), which names t, when a function gives no finite number.
  double at(double t) const;
  // The mean from one moment to a later one: exact where there are points, of a function by Gauss's
  // rule of two points on sixteen pieces. at(from) when there is no time between them.
  double mean(double from, double to) const;

  // "constant", "0 at 0 s, 1 at 2 us", or the text of a function.
  std::string describe() const;

 private:
  std::vector<Vec2> points_;
  std::function<double(double)> function_;
  std::string text_;
};

// 0 at t = 0, 1 from `duration` (s) on.
Amplitude ramp(double duration);
// 0 before `start` (s), 1 from it on.
Amplitude step_at(double start);
// 1 from `start` for `duration` (s), 0 else.
Amplitude pulse(double duration, double start);

// Adds a problem when the moments do not ascend or anything is not finite.
void check(const Amplitude& amplitude, const std::string& who, Problems& problems);

// The amplitude of any load, as its noun describes it.
inline constexpr About about_amplitude{
    .fallback = "1 for ever",
    .sentence = "Factor over time: ramp(2*us), pulse(1*us), {{t, factor}, ...} or function(t)."};

}  // namespace hackle
