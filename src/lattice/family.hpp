// SPDX-License-Identifier: MIT
// The family of a node on the lattice: which offsets it is bonded to, and with what weight. The
// same for every node, so nothing is stored per bond but one bit.
#pragma once

#include <vector>

#include "lattice/numerics.hpp"

namespace hackle {

// The mirror images of one offset share length and weight. A quad has the four directions (+a,+b),
// (+a,-b), (-a,+b), (-a,-b) with a, b > 0; a pair lies on an axis and has two, (+a,0), (-a,0) or
// (0,+b), (0,-b).
//
// A bond is kept by its lower end, or by its left end when both are in one row: a quad has two kept
// bonds, (+a,+b) and (-a,+b), a pair one.
struct Images {
  int a = 0;            // columns, >= 0
  int b = 0;            // rows, >= 0
  Vec2 xi{0, 0};        // the bond itself, in units of dx: (a, b), unless the quadrature moves it
  double weight = 0.0;  // of quadrature and micromodulus, above 0, at most 1
  int first_bit = 0;    // bit of the first kept bond in a node's bond bits; the other follows, in
                        // the same word of 32

  bool is_quad() const { return a > 0 && b > 0; }
  int kept() const { return is_quad() ? 2 : 1; }
  double length() const { return xi.norm(); }  // in units of dx
};

class Family {
 public:
  // All offsets whose weight is above 1e-12. With full and ramp these are a^2 + b^2 <= m^2, decided
  // in integers: m is taken as whole when it is within 1e-9 of a whole number. With area and
  // centroid all whose cell lies partly inside the horizon, which may be up to m + 1/2 columns or
  // rows away. A conical micromodulus leaves out bonds of at least the length of the horizon.
  Family(double m, Quadrature quadrature, Micromodulus micromodulus = Micromodulus::constant);

  double m() const { return m_; }
  Quadrature quadrature() const { return quadrature_; }
  Micromodulus micromodulus() const { return micromodulus_; }
  // Rows from far to near, columns from near to far.
  const std::vector<Images>& images() const { return images_; }
  int kept() const { return kept_; }               // bonds kept by an inner node
  int bonds() const { return 2 * kept_; }          // bonds of an inner node
  int reach() const { return reach_; }             // the farthest column or row of a neighbour
  int words() const { return (bits_ + 31) / 32; }  // words of bond bits per node

  // Calls visit(column, row, xi, weight, bit) for every bond that a node keeps, in the order of the
  // bits. Their opposites are the other half of its bonds.
  template <class Visit>
  void for_each_bond(Visit visit) const {
    for (const Images& image : images_) {
      visit(image.a, image.b, image.xi, image.weight, image.first_bit);
      if (!image.is_quad()) continue;
      const Vec2 mirrored(-image.xi.x(), image.xi.y());
      visit(-image.a, image.b, mirrored, image.weight, image.first_bit + 1);
    }
  }

 private:
  double m_;
  Quadrature quadrature_;
  Micromodulus micromodulus_;
  std::vector<Images> images_;
  int kept_ = 0;
  int bits_ = 0;
  int reach_ = 0;
};

}  // namespace hackle
