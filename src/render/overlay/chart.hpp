// SPDX-License-Identifier: MIT
// Charts over time beside the plate.
#pragma once

#include <string>
#include <vector>

#include "scene/vec2.hpp"

namespace hackle {

struct Curve {
  std::string kind;          // "traction"
  std::string place;         // "top": distinguishes curves of a kind; may be empty
  std::vector<Vec2> points;  // (time in s, value), ascending; two of equal time are a jump
};

struct Chart {
  std::string heading;  // "energy"
  std::string unit;     // of the values, SI; "" for a pure number
  double until = 0.0;   // s, the earliest end of the time axis
  std::vector<Curve> curves;
};

// Curves of one kind that never differ are merged into one.
struct NamedCurve {
  std::string name;  // the kind, with its place if there are several
  std::vector<Vec2> points;
};
std::vector<NamedCurve> distinct(const std::vector<Curve>& curves);

// Interpolates linearly between points (at least one), and is constant before the first and after
// the last.
double value_at(const std::vector<Vec2>& points, double time);

// Collects a chart over time. A fresh curve with one point gives only its present value; one with
// more points is the whole curve as now foreseen.
class ChartHistory {
 public:
  // Adds a fresh chart at `time` (s) and returns the chart with its history: single points become
  // curves, and exchanged curves keep their old values up to the moment before. Times must ascend;
  // an earlier time starts a new history.
  const Chart& add(const Chart& fresh, double time);

 private:
  std::vector<Vec2> went_on(const Curve& curve) const;

  Chart fresh_, all_;
  double last_ = 0.0;  // s, of the last call
};

}  // namespace hackle
