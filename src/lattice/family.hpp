// SPDX-License-Identifier: MIT
// The family of a node on the lattice: the offsets it is bonded to, with their weights. It is the
// same for every node, so only one bit per bond is stored.
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
  Vec2 xi{0, 0};        // bond vector in units of dx: (a, b), unless the quadrature moves it
  double weight = 0.0;  // from quadrature and micromodulus, in (0, 1]
  int first_bit = 0;    // bit of the first kept bond in a node's bits; the second follows, in
                        // the same word of 32

  bool is_quad() const { return a > 0 && b > 0; }
  int kept() const { return is_quad() ? 2 : 1; }
  double length() const { return xi.norm(); }  // in units of dx
};

class Family {
 public:
  // Contains all offsets whose weight is above 1e-12. With full and ramp these are a^2 + b^2 <=
  // m^2, decided in integers: m counts as whole if it is within 1e-9 of an integer. With area and
  // centroid they are all offsets whose cell lies partly inside the horizon, up to m + 1/2 columns
  // or rows away. A conical micromodulus excludes bonds at least as long as the horizon.
  Family(double m, Quadrature quadrature, Micromodulus micromodulus = Micromodulus::constant);

  double m() const { return m_; }
  Quadrature quadrature() const { return quadrature_; }
  Micromodulus micromodulus() const { return micromodulus_; }
  // Ordered by rows from far to near, then by columns from near to far.
  const std::vector<Images>& images() const { return images_; }
  int kept() const { return kept_; }       // bonds kept by an inner node
  int bonds() const { return 2 * kept_; }  // bonds of an inner node
  int reach() const { return reach_; }     // largest distance of a neighbour in columns or rows
  int words() const { return (bits_ + 31) / 32; }  // words of bond bits per node

  // Calls visit(column, row, xi, weight, bit) for every bond that a node keeps, in the order of the
  // bits. The opposite bonds are the other half of the node's bonds.
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
