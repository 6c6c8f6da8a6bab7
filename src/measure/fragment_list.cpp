// SPDX-License-Identifier: MIT
#include "measure/fragment_list.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "measure/bond_field.hpp"
#include "scene/geometry.hpp"

namespace hackle {
namespace {

// Calls visit(number, i, j, mass) for every node that is not in a hole; the number of its fragment
// is 0 for a node without bonds.
template <class Visit>
void for_each_node(const Lattice& lattice, const std::vector<int>& numbers, const Visit& visit) {
  const Grid& grid = lattice.grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      if (lattice.is_void(i, j)) continue;
      const double mass = lattice.material_at(i, j).material.rho * grid.dx * grid.dx;
      visit(numbers[grid.index(i, j)], i, j, mass);
    }
}

class Measurement {
 public:
  explicit Measurement(const View& view)
      : view_(view), numbers_(fragment_numbers(view)), velocities_(view.velocities()) {}

  FragmentList list() {
    const int count = *std::ranges::max_element(numbers_);
    found_.all.resize(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) found_.all[static_cast<std::size_t>(k)].number = k + 1;
    add_momenta();
    add_spins();
    add_shares();
    return std::move(found_);
  }

 private:
  MeasuredFragment& fragment(int number) {
    return found_.all[static_cast<std::size_t>(number - 1)];
  }
  Vec2 place(int i, int j) const {
    return view_.lattice().grid.position(i, j) + view_.displacement(i, j);
  }
  const Vec2& velocity(int i, int j) const { return velocities_[view_.lattice().grid.index(i, j)]; }

  void add_momenta() {
    const double dx = view_.lattice().grid.dx;
    int loose = 0;
    for_each_node(view_.lattice(), numbers_, [&](int number, int i, int j, double mass) {
      if (number == 0) {
        ++loose;
        return;
      }
      MeasuredFragment& one = fragment(number);
      one.area = ++one.nodes * dx * dx;
      one.mass += mass;
      one.centre += mass * place(i, j);
      one.velocity += mass * velocity(i, j);
      one.kinetic += 0.5 * mass * velocity(i, j).squaredNorm();
    });
    found_.dust = loose * dx * dx;
    for (MeasuredFragment& one : found_.all) {
      one.centre /= one.mass;
      one.velocity /= one.mass;
    }
  }

  void add_spins() {
    std::vector<double> inertia(found_.all.size());
    for_each_node(view_.lattice(), numbers_, [&](int number, int i, int j, double mass) {
      if (number == 0) return;
      MeasuredFragment& one = fragment(number);
      const Vec2 arm = place(i, j) - one.centre;
      one.spin += mass * cross(arm, velocity(i, j) - one.velocity);
      inertia[static_cast<std::size_t>(number - 1)] += mass * arm.squaredNorm();
    });
    for (std::size_t k = 0; k < inertia.size(); ++k)
      found_.all[k].spin = inertia[k] > 0.0 ? found_.all[k].spin / inertia[k] : 0.0;
  }

  void add_shares() {
    double sum = 0.0;
    for (auto one = found_.all.rbegin(); one != found_.all.rend(); ++one)
      one->passing = sum += one->area;
    for (MeasuredFragment& one : found_.all) one.passing /= sum;
  }

  const View& view_;
  std::vector<int> numbers_;  // by Grid::index, as velocities_
  std::vector<Vec2> velocities_;
  FragmentList found_;
};

}  // namespace

double MeasuredFragment::diameter() const {
  return 2.0 * std::sqrt(area / std::numbers::pi);
}

double FragmentList::median_area() const {
  for (auto one = all.rbegin(); one != all.rend(); ++one)
    if (one->passing >= 0.5) return one->area;
  return 0.0;
}

FragmentList measured_fragments(const View& view) {
  return Measurement(view).list();
}

}  // namespace hackle
