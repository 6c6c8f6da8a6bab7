// SPDX-License-Identifier: MIT
// What the user describes: a plate and all that is on it. Exact geometry in SI units, free of any
// mesh. Origin at the lower left corner, x right, y up. Everything is per metre of thickness.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "scene/loads.hpp"
#include "scene/material.hpp"
#include "scene/shape.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// Whether the bonds that a crack cuts count as damage, or were never there.
enum class Born { broken, absent };

// A crack of zero width along straight pieces. It cuts every bond that has a point in common with
// it; its two ends do not belong to it, unless they are the same point. No mirror changes that
// rule.
struct Crack {
  Crack() = default;
  Crack(const Vec2& from, const Vec2& to, Born how = Born::broken) : points{from, to}, born(how) {}
  Crack(std::vector<Vec2> along, Born how) : points(std::move(along)), born(how) {}

  std::vector<Vec2> points;  // m, on the plate; at least two
  Born born = Born::broken;
};

// Material taken away: a hole or a notch. Nodes inside are void, bonds that pass through are
// absent.
struct Cutout {
  Shape shape;
  std::string name;  // by which a pressure finds its rim; "" for none
};

// Another material. A node inside is of it, by the last inclusion that covers the node.
struct Inclusion {
  Shape shape;
  Material material;
};

// Displacement and velocity at t = 0, added where areas overlap.
struct Start {
  Region region;
  VectorField displacement;  // m
  VectorField velocity;      // m/s
};

// How strength differs from place to place: the critical stretch of a node is s0 times a factor of
// mean 1 drawn from a distribution. The same flaws for every spacing once they are correlated.
struct Scatter {
  enum class Kind { weibull, normal };
  Kind kind = Kind::weibull;
  double spread = 0.0;       // Weibull modulus in [1, 1000], or standard deviation of a normal
                             // distribution in (0, 0.3]
  double correlation = 0.0;  // m, >= 0; 0: each node for itself
  std::int64_t seed = 1;
};

// Nodes that lack bonds push each other away when they come near: with `stiffness` times the
// micromodulus, below `reach` times their distance at rest (see contact_forces.hpp). By default as
// in LAMMPS.
struct Contact {
  double stiffness = 15.0;  // in (0, 100]
  double reach = 0.9;       // in (0, 1]
};

// Thin, free of stress across its thickness, or thick, held from straining across it. Bond-based
// theory makes Poisson's ratio 1/3 in plane stress and 1/4 in plane strain
// (src/lattice/README.md 3.2).
enum class Plane { stress, strain };
inline constexpr std::array<std::string_view, 2> plane_names{"stress", "strain"};

struct Plate {
  double width = 0.0;   // m, along x, > 0
  double height = 0.0;  // m, along y, > 0
  Material material;
  Plane plane = Plane::stress;
  std::vector<Cutout> cutouts;
  std::vector<Inclusion> inclusions;  // 254 at most
  std::vector<Crack> cracks;
  // Areas, rims included, in which bonds never break; a bond with one end in one is safe too.
  std::vector<Shape> no_fail;
  std::vector<Start> starts;
  std::optional<Scatter> scatter;
  std::optional<Contact> contact;
  Loads loads;
};

// 0 without contact.
double contact_stiffness(const Plate& plate);

// The strip of width `depth` along an edge.
Shape strip(const Plate& plate, Edge edge, double depth);

// Adds a problem for everything in the plate (or in one thing that is to go on it) that makes no
// sense: sizes, materials, cracks of no length or off the plate, zones off the plate, stresses that
// are no numbers.
void check(const Plate& plate, Problems& problems);
void check(const Plate& plate, const Crack& crack, Problems& problems);
// `who` names the call: "hole".
void check(const Plate& plate, const Shape& shape, const std::string& who, Problems& problems);
// Also that it leaves something of the plate.
void check_cutout(const Plate& plate, const Shape& shape, const std::string& who,
                  Problems& problems);
void check(const Scatter& scatter, Problems& problems);
void check(const Contact& contact, Problems& problems);
void check_no_fail(const Plate& plate, const Shape& zone, Problems& problems);

// "strength scattered (Weibull modulus 10, correlated over 2 mm, seed 1)"
std::string describe(const Scatter& scatter);

// "plate 100 x 40 mm, Duran 50 (E 65 GPa, ...), 1 crack, 2 tractions"; plane strain is said too.
std::string describe(const Plate& plate);

}  // namespace hackle
