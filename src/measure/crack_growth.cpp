// SPDX-License-Identifier: MIT
#include "measure/crack_growth.hpp"

#include <algorithm>
#include <utility>

#include "lattice/carve.hpp"
#include "measure/crack_bands.hpp"
#include "measure/just_broken.hpp"
#include "scene/geometry.hpp"
#include "scene/waves.hpp"

namespace hackle {
namespace {

constexpr double side_of_crack = 0.5;     // damage
constexpr double breadth_of_side = 0.75;  // dx

double rayleigh_speed(const View& view) {
  const Calibration& calibration = view.lattice().calibration;
  return wave_speeds(calibration.moduli.E, calibration.moduli.nu, view.lattice().rho,
                     view.plate().plane)
      .rayleigh;
}

}  // namespace

bool CrackGrowth::holds(int i, int j) const {
  if (!grid_.contains(i, j)) return false;
  const std::size_t node = grid_.index(i, j);
  return initial_[node] > 0 || arrival_[node] == at_start;
}

double CrackGrowth::damage(int i, int j) const {
  if (!grid_.contains(i, j)) return 0.0;
  const std::size_t node = grid_.index(i, j);
  const double lost = initial_[node] == 0
                          ? 0.0
                          : static_cast<double>(initial_[node] - left_[node]) / initial_[node];
  const bool absent = arrival_[node] == at_start && static_cast<float>(lost) <= on_crack;
  return absent ? side_of_crack : lost;
}

void CrackGrowth::examine(std::size_t node, double time) {
  if (arrival_[node] != never || initial_[node] == 0) return;
  const double damage = static_cast<double>(initial_[node] - left_[node]) / initial_[node];
  if (static_cast<float>(damage) <= on_crack) return;
  arrival_[node] = time;
  nodes_.push_back(node);
}

// Damage is relative to the bonds that such a crack has left, so it does not show there.
void CrackGrowth::mark_absent_cracks(const Plate& plate) {
  for (const Crack& crack : plate.cracks) {
    if (crack.born != Born::absent) continue;
    for (std::size_t k = 0; k + 1 < crack.points.size(); ++k) {
      const Segment piece{grid_.from_centre(crack.points[k]),
                          grid_.from_centre(crack.points[k + 1])};
      const Box box{piece.from.cwiseMin(piece.to), piece.from.cwiseMax(piece.to)};
      for_nodes(nodes_near(box, grid_, 1), [&](int i, int j) {
        const std::size_t node = grid_.index(i, j);
        if (arrival_[node] == at_start) return;
        if (distance(piece, grid_.from_centre(i, j)) > breadth_of_side) return;
        arrival_[node] = at_start;
        nodes_.push_back(node);
      });
    }
  }
}

void CrackGrowth::begin(const View& view) {
  const Lattice& lattice = view.lattice();
  grid_ = lattice.grid;
  m_ = lattice.family.m();
  rayleigh_ = rayleigh_speed(view);
  initial_ = lattice.initial_neighbours;
  left_ = degrees(grid_, lattice.family, lattice.bonds);
  arrival_.assign(grid_.nodes(), never);
  nodes_.clear();
  for (std::size_t node = 0; node < initial_.size(); ++node) examine(node, at_start);
  mark_absent_cracks(view.plate());
}

void CrackGrowth::catch_up(const View& view) {
  if (initial_.empty()) begin(view);
  left_ = degrees(grid_, view.lattice().family, view.state().bonds);
  for (std::size_t node = 0; node < left_.size(); ++node) examine(node, view.time());
}

void CrackGrowth::look(const View& view) {
  const Grid& grid = view.lattice().grid;
  const bool same = grid.layout() == grid_.layout() && grid.dx == grid_.dx;
  if (step_ >= 0 && (!same || view.time() < time_)) *this = {};
  if (step_ < 0) since_ = view.time();
  if (step_ >= 0) interval_ = std::max(interval_, view.time() - time_);
  catch_up(view);
  any_broken_ = any_broken_ || !(view.state().bonds == view.lattice().bonds);
  step_ = view.state().step;
  clock_ = view.state().clock;
  time_ = view.time();
}

void CrackGrowth::follow(const Simulation& simulation) {
  const State& state = simulation.state();
  if (step_ >= 0 && state.step != step_ && state.step != step_ + 1) *this = {};
  const bool known = step_ >= 0 && clock_ == state.clock;
  if (known && state.step == step_) return;
  const bool untouched = step_ < 0 && state.step == 0 && clock_ == state.clock;
  if (!untouched && (!known || state.step != step_ + 1)) return look(simulation.view().at_step());
  step_ = state.step;
  time_ = simulation.time_of_step();
  if (untouched) since_ = time_;
  interval_ = std::max(interval_, simulation.dt());
  if (simulation.broken_bonds().empty() || untouched) return;
  const std::vector<LostBond> lost = just_broken(simulation);
  if (initial_.empty()) {
    catch_up(simulation.view().at_step());
    return note_first(lost);
  }
  note_first(lost);
  for (const LostBond& bond : lost) {
    const std::size_t one = grid_.index(bond.i, bond.j);
    const std::size_t other = grid_.index(bond.i + bond.a, bond.j + bond.b);
    --left_[one];
    --left_[other];
    examine(one, time_);
    examine(other, time_);
  }
}

void CrackGrowth::note_first(const std::vector<LostBond>& lost) {
  if (std::exchange(any_broken_, true) || lost.empty()) return;
  const auto middle = [](const LostBond& bond) {
    return Vec2(bond.i + 0.5 * bond.a, bond.j + 0.5 * bond.b);
  };
  const Vec2 first = middle(lost.front());
  Vec2 sum(0.0, 0.0);
  double count = 0.0;
  for (const LostBond& bond : lost) {
    if ((middle(bond) - first).norm() > m_) continue;
    sum += middle(bond);
    count += 1.0;
  }
  first_break_ = {time_, grid_.position(0, 0) + grid_.dx * sum / count};
}

void CrackGrowth::count(const Simulation& simulation) {
  follow(simulation);
  if (initial_.empty()) catch_up(simulation.view().at_step());
}

}  // namespace hackle
