// SPDX-License-Identifier: MIT
// Foundations: a force density -k u on every node of their areas. Energy k u^2/2 per volume goes
// into them and comes back, as work of a load: by halves before and after a step, which is what
// they store, exactly.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "lattice/carve.hpp"
#include "scene/load_names.hpp"
#include "solver/exact_sum.hpp"
#include "solver/terms/bearing.hpp"
#include "solver/terms/forces.hpp"
#include "solver/terms/makers.hpp"

namespace hackle {
namespace {

// What pulls at a node: stiffness along x and y, N/m4.
struct Spring {
  int i = 0;
  int j = 0;
  Vec2 stiffness{0, 0};
};

// The springs of one foundation, by name.
struct Bed {
  std::string name;
  std::vector<Spring> springs;
};

std::vector<Bed> beds_of(const Plate& plate, const Lattice& lattice) {
  std::vector<Bed> beds;
  for (const Foundation& foundation : plate.loads.foundations) {
    std::vector<Spring> springs;
    for_nodes_in(foundation.region, lattice.grid, [&](int i, int j) {
      if (!lattice.is_void(i, j))
        springs.push_back({i, j, {foundation.along_x(), foundation.along_y()}});
    });
    if (springs.empty())
      throw Error(ErrorKind::refused, "foundation: there is no node in its area",
                  "give it a larger area, or a smaller spacing");
    const int number = static_cast<int>(beds.size()) + 1;
    beds.push_back(
        {load_name(foundation.name, description_of<Foundation>.noun, number), std::move(springs)});
  }
  return beds;
}

// Each node once, by index. Stiffnesses are summed exactly: their order means nothing.
std::vector<Spring> joined_by_node(const std::vector<Bed>& beds, const Grid& grid) {
  std::vector<Spring> springs;
  for (const Bed& bed : beds) springs.insert(springs.end(), bed.springs.begin(), bed.springs.end());
  const auto index = [&](const Spring& spring) { return grid.index(spring.i, spring.j); };
  std::ranges::stable_sort(springs, {}, index);
  std::vector<Spring> joined;
  for (auto first = springs.begin(); first != springs.end();) {
    ExactVectorSum sum;
    auto next = first;
    for (; next != springs.end() && index(*next) == index(*first); ++next) sum.add(next->stiffness);
    joined.push_back({first->i, first->j, sum.value()});
    first = next;
  }
  return joined;
}

class Springs final : public Term {
 public:
  Springs(std::vector<Bed> beds, const Lattice& lattice)
      : beds_(std::move(beds)), springs_(joined_by_node(beds_, lattice.grid)) {
    for (const Spring& spring : springs_) {
      const double rho = lattice.material_at(spring.i, spring.j).material.rho;
      forces_.push_back({spring.i, spring.j, {0, 0}, rho / lattice.rho});
      pull_.push_back(spring.stiffness * (-lattice.grid.dx / rho));
    }
  }

  std::unique_ptr<Term> clone() const override { return std::make_unique<Springs>(*this); }
  std::string_view name() const override { return "foundation"; }
  std::span<const LoadedNode> forces() const override { return forces_; }
  bool varies() const override { return true; }
  bool keeps_to_rows() const override { return true; }

  bool update(const Surroundings&, State& state) override {
    for (std::size_t k = 0; k < springs_.size(); ++k) {
      const Vec2 u = state.origin + state.u(springs_[k].i, springs_[k].j);
      forces_[k].acceleration = pull_[k].cwiseProduct(u);
    }
    return true;
  }

  void add_work(const Surroundings& around, const State& state, WorkOf part,
                double& work) const override {
    add_work_of(forces_, around, state, part, work);
  }

  void check_rest(const std::string& who) const override {
    throw Error(ErrorKind::refused,
                fmt::format("{}: a plate on a foundation cannot be brought to rest", who),
                "let s:damping{} calm it while it runs, or hold it by supports instead");
  }

  void add_reactions(const Surroundings& around, const State& state,
                     std::vector<Reaction>& list) const override {
    const Grid& grid = around.lattice.grid;
    for (std::size_t k = 0; k < beds_.size(); ++k) {
      Bearing sum;
      for (const Spring& spring : beds_[k].springs) {
        const Vec2 u = state.origin + state.u(spring.i, spring.j);
        const Vec2 place = grid.from_centre(spring.i, spring.j) + u;
        sum.add(place, spring.stiffness.cwiseProduct(u));
        sum.count(place, u);
      }
      list.push_back(sum.reaction(beds_[k].name, description_of<Foundation>.noun,
                                  static_cast<int>(k) + 1, grid, std::pow(grid.dx, 3)));
    }
  }

 private:
  std::vector<Bed> beds_;
  std::vector<Spring> springs_;  // of all of them, each node once
  std::vector<Vec2> pull_;       // acceleration per displacement of one spacing, m/s2
  std::vector<LoadedNode> forces_;
};

}  // namespace

std::unique_ptr<Term> make_foundation(const Plate& plate, const Lattice& lattice, double) {
  if (plate.loads.foundations.empty()) return nullptr;
  return std::make_unique<Springs>(beds_of(plate, lattice), lattice);
}

}  // namespace hackle
