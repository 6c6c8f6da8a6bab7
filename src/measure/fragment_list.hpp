// SPDX-License-Identifier: MIT
// The fragments of a plate: how large they are and how they fly.
#pragma once

#include <vector>

#include "solver/view.hpp"

namespace hackle {

// Nodes that intact bonds join, each with its whole cell; per metre of thickness.
struct MeasuredFragment {
  int number = 0;  // 1 for the one with the most nodes, as in fragment_numbers() and pictures
  int nodes = 0;
  double area = 0.0;        // m2
  double mass = 0.0;        // kg/m
  Vec2 centre{0, 0};        // m, of mass, of the displaced nodes
  Vec2 velocity{0, 0};      // m/s, of the centre: momentum over mass
  double spin = 0.0;        // rad/s, anticlockwise: angular momentum over moment of inertia, both
                            // about the centre; exact for a rigid motion
  double kinetic = 0.0;     // J/m, of all its nodes, vibration included
  double passing = 0.0;     // 0..1: the share of the area of all fragments in it and in smaller
                            // ones, as a sieve tells it
  double diameter() const;  // m, of a disc of its area
};

// The largest first; equal ones in the order of fragment_numbers().
struct FragmentList {
  std::vector<MeasuredFragment> all;
  double dust = 0.0;  // m2, of the nodes without intact bonds, which are no fragments

  // Returns the area, m2, of the smallest fragment up to which half of the area has been counted,
  // from the smallest on; 0 without fragments.
  double median_area() const;
};

FragmentList measured_fragments(const View& view);

}  // namespace hackle
