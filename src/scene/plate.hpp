// SPDX-License-Identifier: MIT
// What the user describes: a plate and all that is on it. Exact geometry in SI units, free of any
// mesh. Origin at the lower left corner, x right, y up. Everything is per metre of thickness.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "scene/material.hpp"
#include "scene/vec2.hpp"

namespace hackle {

enum class Edge { left, right, bottom, top };

std::string_view name_of(Edge edge);
std::optional<Edge> edge_named(std::string_view name);

// Whether the bonds that a crack cuts count as damage, or were never there.
enum class Born { broken, absent };

// A straight crack of zero width. It cuts every bond that has a point in common with it; its two
// ends do not belong to it. No mirror changes that rule.
struct Crack {
  Vec2 from{0, 0};  // m, on the plate
  Vec2 to{0, 0};    // m, on the plate
  Born born = Born::broken;
};

// A stress vector on a whole edge from t = 0 on, positive along x and y. It acts as a body force
// on the outermost row of nodes, so that the resultant is exact.
struct Traction {
  Edge edge = Edge::top;
  Vec2 stress{0, 0};  // Pa
};

// A rectangle in which bonds never break; a bond with one end in it is safe too.
struct NoFail {
  Vec2 least{0, 0};  // m, lower left corner, included
  Vec2 most{0, 0};   // m, upper right corner, included
};

// Thin, free of stress across its thickness, or thick, held from straining across it. Bond-based
// theory makes Poisson's ratio 1/3 in plane stress and 1/4 in plane strain (physics.md 4.1).
enum class Plane { stress, strain };
inline constexpr std::array<std::string_view, 2> plane_names{"stress", "strain"};

struct Plate {
  double width = 0.0;   // m, along x, > 0
  double height = 0.0;  // m, along y, > 0
  Material material;
  Plane plane = Plane::stress;
  std::vector<Crack> cracks;
  std::vector<Traction> tractions;
  std::vector<NoFail> no_fail;
};

// The strip of width `depth` along an edge, as a no-fail zone.
NoFail strip(const Plate& plate, Edge edge, double depth);

// Adds a problem for everything in the plate (or in one thing that is to go on it) that makes no
// sense: sizes, materials, cracks of no length or off the plate, zones off the plate, stresses that
// are no numbers.
void check(const Plate& plate, Problems& problems);
void check(const Plate& plate, const Crack& crack, Problems& problems);
void check(const Plate& plate, const NoFail& zone, Problems& problems);
void check(const Traction& traction, Problems& problems);

// "plate 100 x 40 mm, Duran 50 (E 65 GPa, ...), 1 crack, 2 tractions"; plane strain is said too.
std::string describe(const Plate& plate);

}  // namespace hackle
