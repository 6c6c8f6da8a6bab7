// SPDX-License-Identifier: MIT
// The family of a node on the lattice: which offsets it is bonded to, and with what weight. The
// same for every node, so nothing is stored per bond but one bit.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice/numerics.hpp"

namespace hackle {

// The mirror images of one offset share length and weight. A quad has the four directions (+a,+b),
// (+a,-b), (-a,+b), (-a,-b) with a, b > 0; a pair lies on an axis and has two, (+a,0), (-a,0) or
// (0,+b), (0,-b). Forces of images are summed as (f1 + f2) + (f3 + f4), which no mirror changes.
struct Images {
  int a = 0;            // columns, >= 0
  int b = 0;            // rows, >= 0
  double weight = 0.0;  // quadrature weight, in (0, 1]
  int first_bit = 0;    // bit of the first image in a node's bond bits; the others follow

  bool is_quad() const { return a > 0 && b > 0; }
  int count() const { return is_quad() ? 4 : 2; }
  // The offset of image k, 0 <= k < count().
  int column(int k) const;
  int row(int k) const;
  double length() const;  // in units of dx
};

class Family {
 public:
  // All offsets with a^2 + b^2 <= m^2, decided in integers: m is taken as whole when it is within
  // 1e-9 of a whole number.
  Family(double m, Quadrature quadrature);

  double m() const { return m_; }
  Quadrature quadrature() const { return quadrature_; }
  const std::vector<Images>& images() const { return images_; }
  int bonds() const { return bonds_; }              // directed bonds of an inner node
  int reach() const { return reach_; }              // the farthest column or row of a neighbour
  int words() const { return (bonds_ + 63) / 64; }  // 64-bit words of bond bits per node

  // Calls visit(column, row, weight, bit) for every directed bond, in the order of the bits.
  template <class Visit>
  void for_each_bond(Visit visit) const {
    for (const Images& image : images_)
      for (int k = 0; k < image.count(); ++k)
        visit(image.column(k), image.row(k), image.weight, image.first_bit + k);
  }

 private:
  double m_;
  Quadrature quadrature_;
  std::vector<Images> images_;
  int bonds_ = 0;
  int reach_ = 0;
};

}  // namespace hackle
