// SPDX-License-Identifier: MIT
// The cracks of a plate as a graph, and what happened to them: where they began, forked, met, stood
// still and came to a rim.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "measure/crack_growth.hpp"

namespace hackle {

enum class CrackEventKind { nucleation, branch, coalescence, arrest, arrival };
std::string_view name_of(CrackEventKind kind);

// Where a crack begins or ends: amid the plate, at its edge, or at a hole.
enum class CrackSite { inside, edge, hole };
std::string_view name_of(CrackSite site);

struct CrackEvent {
  CrackEventKind kind = CrackEventKind::nucleation;
  std::optional<double> time;   // s; none: before the growth was seen for the first time
  Vec2 place{0, 0};             // m
  int crack = 0;                // in CrackGraph::cracks; of a branch event, the one that forked
  int other = -1;               // of a coalescence, the one that it met; else -1
  std::optional<double> angle;  // rad, between the branches of a branch event, 0 to pi
  std::optional<double> speed;  // m/s, of the tip when it came there
  CrackSite site = CrackSite::inside;
};

enum class TipState { initial, running, arrested, arrived, joined };
std::string_view name_of(TipState state);

// A piece of a crack without a fork, from where it began or forked to its tip or the next fork. A
// crack of the scene is a piece of its own; what grows out of it has it as its parent.
struct CrackPiece {
  int parent = -1;            // in CrackGraph::cracks; -1: none
  bool initial = false;       // of the scene
  std::vector<Vec2> points;   // m, along its middle
  std::vector<double> times;  // s, when the tip came to each, ascending; of a crack of the scene,
                              // CrackGrowth::at_start
  double length = 0.0;        // m
  std::optional<double> max_speed;  // m/s, see CrackTip::speed
};

struct CrackTip {
  int crack = 0;
  Vec2 place{0, 0};      // m
  Vec2 direction{0, 0};  // of length 1, outwards
  TipState state = TipState::running;
  // m/s along the path: the line with the least squares through its way against time over the last
  // two horizons; it falls to 0 while the tip stays. 0 if the growth was not seen.
  double speed = 0.0;
};

struct CrackGraph {
  double time = 0.0;               // s
  double rayleigh = 0.0;           // m/s, speed of Rayleigh waves
  std::vector<CrackPiece> cracks;  // in order of birth, each behind its parent
  std::vector<CrackTip> tips;
  std::vector<CrackEvent> events;  // in order of time
};

// Places are middles of the damage, tips as in end_of_line(), forks where the fitted middle lines
// of the two branches meet, from where they are 1.5 horizons apart over the next 2.5, or 20
// spacings; their angle is that of these lines. A tip is arrested when it has advanced by less than
// a node for the time that a Rayleigh wave takes for ten horizons, and three looks. Costs in
// proportion to what is broken.
CrackGraph crack_graph(const CrackGrowth& growth);

}  // namespace hackle
