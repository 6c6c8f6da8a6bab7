// SPDX-License-Identifier: MIT
// Forces on nodes, added up to the reaction of what bears them.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "lattice/grid.hpp"
#include "scene/geometry.hpp"
#include "solver/reaction.hpp"

namespace hackle {

// Places are in dx from the centre of the lattice, forces in any unit.
class Bearing {
 public:
  void add(const Vec2& place, const Vec2& force) {
    force_ += force;
    moment_ += cross(place, force);
  }
  // Counts a node among those whose place and displacement, dx, are averaged.
  void count(const Vec2& place, const Vec2& u) {
    place_ += place;
    moved_ += u;
    nodes_ += 1.0;
  }

  // `unit` is that of forces, N/m. The centre is that of the counted nodes.
  Reaction reaction(std::string name, std::string_view who, int number, const Grid& grid,
                    double unit) const {
    const double share = nodes_ > 0.0 ? grid.dx / nodes_ : 0.0;
    const Vec2 force = unit * force_;
    return {std::move(name), who,
            number,          grid.centre + share * place_,
            force,           cross(grid.centre, force) + unit * grid.dx * moment_,
            share * moved_};
  }

 private:
  Vec2 force_{0, 0}, place_{0, 0}, moved_{0, 0};
  double moment_ = 0.0, nodes_ = 0.0;
};

}  // namespace hackle
