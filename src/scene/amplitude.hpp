// SPDX-License-Identifier: MIT
// The amplitude of a load: its factor as a function of time.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/described.hpp"
#include "base/error.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// A factor as a function of time: constant 1, piecewise linear, or any function.
class Amplitude {
 public:
  Amplitude() = default;
  // Takes points (t in s, factor), t ascending; two points with the same t are a jump, and at(t) is
  // the second. The factor is constant before the first and after the last point.
  explicit Amplitude(std::vector<Vec2> points);
  // Calls `function` with t in s; it may throw Error. `text` describes it.
  Amplitude(std::function<double(double)> function, std::string text);

  bool is_constant() const { return points_.empty() && !function_; }
  bool is_function() const { return static_cast<bool>(function_); }
  const std::vector<Vec2>& points() const { return points_; }
  // Of the same points; a function is equal to none.
  friend bool operator==(const Amplitude& one, const Amplitude& other) {
    return !one.is_function() && !other.is_function() && one.points_ == other.points_;
  }

  // Returns the factor at t. Throws Error (refused), which names t, if a function gives no finite
  // number.
  double at(double t) const;
  // Returns the mean over an interval: exact for points; for a function by two-point Gauss
  // quadrature on sixteen subintervals. Returns at(from) if the interval is empty.
  double mean(double from, double to) const;

  // Returns the largest magnitude of the factor, and of its change per s: infinite with a jump.
  // Both only of points: a constant is 1 and does not change, a function counts as 0.
  double largest() const;
  double steepest() const;

  // Returns "constant", "0 at 0 s, 1 at 2 us", or the text of a function.
  std::string describe() const;

 private:
  std::vector<Vec2> points_;
  std::function<double(double)> function_;
  std::string text_;
};

// Rises linearly from 0 at t = 0 to 1 at `duration` (s), then stays 1.
Amplitude ramp(double duration);
// Is 0 before `start` (s) and 1 from then on.
Amplitude step_at(double start);
// Is 1 for `duration` (s) from `start`, and 0 elsewhere.
Amplitude pulse(double duration, double start);

// Adds a problem if the times do not ascend or a value is not finite.
void check(const Amplitude& amplitude, const std::string& who, Problems& problems);

// The member that every load has for its amplitude.
inline constexpr About about_amplitude{.fallback = "constant 1",
                                       .sentence =
                                           "Amplitude, a factor over time: ramp(2*us), "
                                           "pulse(1*us), {{t, factor}, ...} or function(t)."};

}  // namespace hackle
