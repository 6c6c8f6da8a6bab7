// SPDX-License-Identifier: MIT
#include "measure/crack_track.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/crack_bands.hpp"
#include "measure/field.hpp"
#include "measure/just_broken.hpp"

namespace hackle {
namespace {

constexpr double breadth_of_front = 0.5;  // dx
constexpr double horizons_of_speed = 2.0;

// The offset of a bond of a family.
struct Reach {
  int a = 0, b = 0;
  double length = 0.0, weight = 0.0;
};

std::vector<Reach> reaches_of(const Family& family) {
  std::vector<Reach> all;
  family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int bit) {
    all.resize(std::max(all.size(), static_cast<std::size_t>(bit) + 1));
    all[static_cast<std::size_t>(bit)] = {a, b, xi.norm(), weight};
  });
  return all;
}

}  // namespace

CrackTrack::CrackTrack(const Vec2& direction) : direction_(direction.stableNormalized()) {
}

void CrackTrack::begin_anew(const View& view) {
  const Lattice& lattice = view.lattice();
  grid_ = lattice.grid;
  window_ = horizons_of_speed * lattice.family.m();
  broken_bonds_ = 0;
  broken_energy_ = length_ = max_damage_ = 0.0;
  on_crack_.assign(grid_.nodes(), 0);
  front_.clear();
  farthest_ = -std::numeric_limits<double>::infinity();
}

// Books a bond from node (i, j) to (i + a, j + b).
void CrackTrack::lose(const View& view, int i, int j, int a, int b, double length, double weight) {
  const Lattice& lattice = view.lattice();
  const double unit = 0.5 * std::pow(grid_.dx, 5) * weight * length;
  const double c = 0.5 * (lattice.micromodulus_at(i, j) + lattice.micromodulus_at(i + a, j + b));
  const double s0 =
      std::min(lattice.critical_stretch_at(i, j), lattice.critical_stretch_at(i + a, j + b));
  const Calibration& whole = lattice.material_at(i, j).calibration;
  ++broken_bonds_;
  broken_energy_ += unit * c * s0 * s0;
  length_ += unit * whole.c * whole.s0 * whole.s0 / whole.G0;
}

void CrackTrack::examine(int i, int j, double damage) {
  max_damage_ = std::max(max_damage_, damage);
  char& known = on_crack_[grid_.index(i, j)];
  if (known != 0 || static_cast<float>(damage) <= on_crack) return;
  known = 1;
  const Vec2 place = grid_.from_centre(i, j);
  const double along = direction_.dot(place);
  if (along < farthest_ - breadth_of_front) return;
  farthest_ = std::max(farthest_, along);
  front_.push_back(place);
  std::erase_if(front_, [&](const Vec2& node) {
    return direction_.dot(node) < farthest_ - breadth_of_front;
  });
}

void CrackTrack::note_advance(double time) {
  time_ = time;
  if (std::isinf(farthest_)) return;
  if (!arrivals_.empty() && arrivals_.back().along >= farthest_) return;
  arrivals_.push_back({time, farthest_, broken_energy_});
  // The first is where it was when it was first seen: it had come there earlier.
  while (arrivals_.size() > 3 && arrivals_[2].along <= farthest_ - window_) arrivals_.pop_front();
}

void CrackTrack::look(const View& view) {
  begin_anew(view);
  const Lattice& lattice = view.lattice();
  const std::vector<Reach> reaches = reaches_of(lattice.family);
  for_each_missing(lattice.bonds, view.state().bonds, lattice, [&](const KeptBond& bond) {
    const Reach& reach = reaches[static_cast<std::size_t>(bond.bit)];
    lose(view, bond.i, bond.j, reach.a, reach.b, reach.length, reach.weight);
  });
  const std::vector<std::uint16_t> left = degrees(grid_, lattice.family, view.state().bonds);
  for (int j = 0; j < grid_.ny; ++j)
    for (int i = 0; i < grid_.nx; ++i) {
      const int initial = lattice.initial_neighbours[grid_.index(i, j)];
      if (initial > 0)
        examine(i, j, static_cast<double>(initial - left[grid_.index(i, j)]) / initial);
    }
  clock_ = view.state().clock;
  step_ = view.state().step;
  note_advance(view.time());
}

std::vector<double> CrackTrack::memory() const {
  if (step_ < 0) return recalled_;
  std::vector<double> memory{broken_energy_, length_};
  for (const Arrival& arrival : arrivals_)
    memory.insert(memory.end(), {arrival.time, arrival.along, arrival.energy});
  return memory;
}

void CrackTrack::take_up_memory() {
  const std::vector<double> memory = std::exchange(recalled_, {});
  if (memory.size() < 2) return;
  broken_energy_ = memory[0];
  length_ = memory[1];
  arrivals_.clear();
  for (std::size_t k = 2; k + 2 < memory.size(); k += 3)
    arrivals_.push_back({memory[k], memory[k + 1], memory[k + 2]});
}

void CrackTrack::follow(const Simulation& simulation) {
  const State& state = simulation.state();
  const bool known = step_ >= 0 && clock_ == state.clock;
  if (known && state.step == step_) return;
  if (!known || state.step != step_ + 1) {
    look(simulation.view().at_step());
    return take_up_memory();
  }
  step_ = state.step;
  if (!simulation.broken_bonds().empty()) {
    const View view = simulation.view().at_step();
    for (const LostBond& bond : just_broken(simulation)) {
      const int k = bond.i + bond.a, l = bond.j + bond.b;
      lose(view, bond.i, bond.j, bond.a, bond.b, bond.length, bond.weight);
      examine(bond.i, bond.j, damage_of(view, bond.i, bond.j));
      examine(k, l, damage_of(view, k, l));
    }
  }
  note_advance(simulation.time_of_step());
}

std::optional<Vec2> CrackTrack::tip() const {
  if (front_.empty()) return std::nullopt;
  Vec2 min = front_.front(), max = min;
  for (const Vec2& node : front_) {
    min = min.cwiseMin(node);
    max = max.cwiseMax(node);
  }
  return grid_.centre + 0.5 * grid_.dx * (min + max);
}

double CrackTrack::speed() const {
  if (arrivals_.size() < 3) return 0.0;
  const Arrival &from = arrivals_[1], &to = arrivals_.back();
  const double way = to.along - from.along, took = to.time - from.time;
  const double waits = time_ - to.time - took / std::max(way, 1.0);
  return took > 0.0 ? grid_.dx * way / (took + std::max(waits, 0.0)) : 0.0;
}

std::optional<double> CrackTrack::energy_per_length() const {
  if (arrivals_.size() < 3) return std::nullopt;
  const Arrival &from = arrivals_[1], &to = arrivals_.back();
  return (to.energy - from.energy) / (grid_.dx * (to.along - from.along));
}

}  // namespace hackle
