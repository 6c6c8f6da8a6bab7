// SPDX-License-Identifier: MIT
// Runs whose cracks are known.
#pragma once

#include <cmath>
#include <vector>

#include "study/case.hpp"

namespace hackle::test {

using Told = nlohmann::ordered_json;

// A crack from (x0, y0) to (x1, y1), mm, that grows evenly from `from` to `to`, us.
struct Growth {
  double x0, y0, x1, y1;
  double from, to;
};

inline Told piece_of(const Growth& growth) {
  constexpr int pieces = 40;
  Told points = Told::array(), times = Told::array();
  for (int k = 0; k <= pieces; ++k) {
    const double share = static_cast<double>(k) / pieces;
    points.push_back({1e-3 * (growth.x0 + share * (growth.x1 - growth.x0)),
                      1e-3 * (growth.y0 + share * (growth.y1 - growth.y0))});
    times.push_back(1e-6 * (growth.from + share * (growth.to - growth.from)));
  }
  const double length = 1e-3 * std::hypot(growth.x1 - growth.x0, growth.y1 - growth.y0);
  return {{"parent", -1},
          {"initial", false},
          {"length_m", length},
          {"points_m", points},
          {"times_s", times}};
}

// A run of a plate of 100 mm x 40 mm, with Rayleigh waves of 2 km/s.
inline Outcome told_run(const std::vector<Growth>& cracks) {
  Outcome outcome;
  outcome.state = CaseState::finished;
  Told all = Told::array(), tips = Told::array();
  for (const Growth& one : cracks) {
    all.push_back(piece_of(one));
    tips.push_back({{"state", "running"}});
  }
  outcome.told["graph"] = {{"c_R_m_per_s", 2000.0}, {"cracks", all}, {"tips", tips}};
  outcome.told["plate"] = {{"width_m", 0.1}, {"height_m", 0.04}, {"rows", {"##", "#."}}};
  outcome.told["fragments"] = {{"areas_m2", {3e-3, 6e-4, 4e-4}}, {"dust_m2", 0.0}};
  return outcome;
}

}  // namespace hackle::test
