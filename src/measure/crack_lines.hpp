// SPDX-License-Identifier: MIT
// The paths of a skeleton as middle lines below the spacing, cut into pieces at forks and where the
// cracks of the scene end; the step between the skeleton and the graph.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "measure/crack_skeleton.hpp"
#include "measure/ridge_line.hpp"

namespace hackle {

struct CrackLine {
  Points points;
  std::vector<double> ways;   // dx, from the first point, before forks and tips were placed
  std::vector<double> times;  // s, ascending
  int parent = -1;
  std::size_t leaves = 0;  // point of the parent; 0 also within a horizon of its origin
  std::size_t grown = 0;   // the first point that is not of a crack of the scene
  std::size_t last() const { return points.size() - 1; }
};

// A part of a line, both points included.
struct LinePiece {
  int line = 0;
  std::size_t first = 0, last = 0;
  int parent = -1;  // among the pieces
};

struct LineFork {
  int parent = -1;  // piece that forked; the pieces are those of the branches
  int one = 0, other = 0;
  Vec2 place{0, 0};    // dx
  double angle = 0.0;  // rad
  double time = 0.0;   // s
};

struct CrackLines {
  std::vector<CrackLine> lines;
  std::vector<LinePiece> pieces;  // each behind its parent
  std::vector<LineFork> forks;
};

// Moves the lines to the forks, whose branches have been drawn together there by their damage.
CrackLines crack_lines(const CrackGrowth& growth, const CrackSkeleton& skeleton);

}  // namespace hackle
