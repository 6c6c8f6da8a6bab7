// SPDX-License-Identifier: MIT
// A diagram: curves over a pair of axes, as data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/scalar.hpp"
#include "scene/vec2.hpp"

namespace hackle {

struct DiagramAxis {
  std::string name;           // "tip speed"
  std::string unit;           // of the values, SI; "" for a pure number
  std::optional<Ends> range;  // min < max; default: what the curves take up
  bool logarithmic = false;   // values that are not above 0 are left out
};

// How the points of a curve are drawn. A bar stands on 0 and is as wide as its neighbours are
// apart.
enum class DiagramStroke { line, dots, bars };

struct DiagramCurve {
  std::string name;
  std::vector<Vec2> points;  // a point that is not finite interrupts a line
  DiagramStroke stroke = DiagramStroke::line;
  std::string mark{};  // a short text beside its last point
};

// A value to compare with: a line across the diagram.
struct DiagramLevel {
  std::string name;  // "c_R"
  double value = 0.0;
};

struct Diagram {
  std::string title;  // may be empty
  DiagramAxis x, y;
  std::vector<DiagramCurve> curves;
  std::vector<DiagramLevel> levels;
  bool to_scale = false;  // a length along x is as long along y: a map
};

}  // namespace hackle
