// SPDX-License-Identifier: MIT
// What acts on a plate. A load is a quantity in space times a factor of time; all may be exchanged
// while a plate is being solved.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "scene/course.hpp"
#include "scene/field_of_place.hpp"
#include "scene/shape.hpp"

namespace hackle {

enum class Edge { left, right, bottom, top };

std::string_view name_of(Edge edge);
std::optional<Edge> edge_named(std::string_view name);

// Where something acts; nothing is the whole plate.
using Region = std::optional<Shape>;

// A stress vector on an edge, positive along x and y. It acts as a body force on the outermost
// nodes, or on all nodes down to `depth`; the resultant is the same.
struct Traction {
  Edge edge = Edge::top;
  VectorField stress;  // Pa
  double depth = 0.0;  // m, >= 0
  Course course;
};

// A pressure on the rim of a hole or notch, positive into the material.
struct Pressure {
  std::string rim;        // name of the cut-out
  double pressure = 0.0;  // Pa
  Course course;
};

struct BodyForce {
  Region region;
  VectorField force;  // N/m3
  Course course;
};

// Nodes whose motion is prescribed along x, y or both: a clamp when it is 0.
struct Support {
  enum class Kind { displacement, velocity };
  Region region;
  Kind kind = Kind::displacement;
  VectorField value;  // m or m/s, of the moment when the factor is 1
  bool along_x = true;
  bool along_y = true;
  Course course;
};

// A change of temperature, which stretches every free bond by alphaT times it.
struct Heating {
  Region region;
  ScalarField change;  // K
  Course course;
};

// A rigid disc in the plane of the plate that flies freely and pushes what it meets.
struct Impactor {
  Vec2 centre{0, 0};    // m, at the start
  double radius = 0.0;  // m, > 0
  Vec2 velocity{0, 0};  // m/s, at the start
  double mass = 0.0;    // kg/m of thickness, > 0
};

struct Loads {
  std::vector<Traction> tractions;
  std::vector<Pressure> pressures;
  std::vector<BodyForce> body_forces;
  std::vector<Support> supports;
  std::vector<Heating> heatings;
  std::vector<Impactor> impactors;
  double damping = 0.0;  // 1/s, >= 0: every velocity dies away as exp(-damping t)
};

// Loads are checked by themselves; whether a rim or a region exists is checked with the plate.
void check(const Traction& traction, Problems& problems);
void check(const Pressure& pressure, Problems& problems);
void check(const BodyForce& force, Problems& problems);
void check(const Support& support, Problems& problems);
void check(const Heating& heating, Problems& problems);
void check(const Impactor& impactor, Problems& problems);
void check(const Loads& loads, Problems& problems);

// ", 2 tractions, 1 support", or "".
std::string describe(const Loads& loads);

}  // namespace hackle
