// SPDX-License-Identifier: MIT
// What is shown over time beside the plate.
#pragma once

#include <string>
#include <vector>

#include "scene/vec2.hpp"

namespace hackle {

struct Curve {
  std::string kind;          // "traction"
  std::string place;         // "top": tells it from others of its kind; may be empty
  std::vector<Vec2> points;  // (time in s, value), in order; two of the same time are a jump
};

struct Chart {
  std::string heading;  // "energy"
  std::string unit;     // of the values, SI; "" for a pure number
  double until = 0.0;   // s, where the axis of time ends at least
  std::vector<Curve> curves;
};

// Curves of a kind that never differ are one.
struct NamedCurve {
  std::string name;  // the kind, with its place where there are several of it
  std::vector<Vec2> points;
};
std::vector<NamedCurve> distinct(const std::vector<Curve>& curves);

// Of the line through points (at least one), which goes on level before the first and after the
// last.
double value_at(const std::vector<Vec2>& points, double time);

// What is known of a chart at one moment after another. A curve that comes with one point has only
// its present value; one with more is its whole course, as it is foreseen now.
class ChartHistory {
 public:
  // The chart with all that was, at a time, s: single points become curves, and courses that were
  // exchanged show what they were until the moment before. Times go forwards; one that does not
  // begins anew.
  const Chart& add(const Chart& fresh, double time);

 private:
  std::vector<Vec2> went_on(const Curve& curve) const;

  Chart fresh_, all_;
  double last_ = 0.0;  // s, of the last moment
};

}  // namespace hackle
