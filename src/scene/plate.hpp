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
#include "scene/loads/initial_condition.hpp"
#include "scene/material.hpp"
#include "scene/shape.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// Whether the bonds that a crack cuts count as damage, or were never there.
enum class Born { broken, absent };

template <>
inline constexpr auto enum_names<Born> = std::to_array<std::string_view>({"broken", "absent"});

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

template <>
inline constexpr auto description_of<Crack> = describe_noun(
    "crack", "crack",
    member("points", &Crack::points,
           {.unit = "m",
            .range = between(2, max_points),
            .alternative = true,
            .sentence = "Along a crack of straight pieces; it is closed when first and last are "
                        "the same."}),
    member("born", &Crack::born,
           {.fallback = "broken",
            .sentence = "Whether the bonds it cuts count as damage or were never there."}));

// Material taken away: a hole or a notch. Nodes inside are void, bonds that pass through are
// absent.
struct Cutout {
  Shape shape;
  std::string name;  // by which a pressure finds its rim; "" for none
};

template <>
inline constexpr auto description_of<Cutout> = describe_noun(
    "cut-out", "cut-out", member("shape", &Cutout::shape, {.required = true}),
    member("name", &Cutout::name,
           {.alternative = true,
            .sentence = "By which p:pressure finds its rim; several may share one."}));

// Another material. A node inside is of it, by the last inclusion that covers the node.
struct Inclusion {
  Shape shape;
  Material material;
};

template <>
inline constexpr auto description_of<Inclusion> =
    describe_noun("inclusion", "inclusion", member("shape", &Inclusion::shape, {.required = true}),
                  member("material", &Inclusion::material,
                         {.required = true, .sentence = "What it is made of."}));

// How strength differs from place to place: the critical stretch of a node is s0 times a factor of
// mean 1 drawn from a distribution. The same flaws for every spacing once they are correlated.
struct Scatter {
  enum class Kind { weibull, normal };
  Kind kind = Kind::weibull;
  double spread = 0.0;       // Weibull modulus, or standard deviation of a normal distribution
  double correlation = 0.0;  // m; 0: each node for itself
  std::int64_t seed = 1;
};

template <>
inline constexpr auto enum_names<Scatter::Kind> = std::to_array<std::string_view>({"weibull",
                                                                                   "normal"});

template <>
inline constexpr auto description_of<Scatter> = describe_noun(
    "strength", "scatter",
    member("distribution", &Scatter::kind,
           {.fallback = "weibull",
            .sentence = "Of the critical stretch over that of the material; its mean is 1."}),
    kind_member(
        &Scatter::kind, &Scatter::spread, std::to_array<std::string_view>({"modulus", "deviation"}),
        std::to_array<About>(
            {{.range = between(1.0, 1000.0),
              .required = true,
              .alternative = true,
              .sentence = "Weibull modulus; 5 to 15 is usual for glass, more scatters less."},
             {.range = above_up_to(0.0, 0.3),
              .required = true,
              .alternative = true,
              .sentence = "Standard deviation of a normal distribution; it is cut off at three.",
              .remedy = "what scatters more follows a Weibull distribution"}})),
    member("correlation", &Scatter::correlation,
           {.unit = "m",
            .range = at_least(0.0),
            .fallback = "0",
            .sentence = "Distance over which strength changes; 0: every node for itself, and then "
                        "the flaws depend on the spacing."}),
    member("seed", &Scatter::seed,
           {.fallback = "1", .sentence = "Another whole number gives other flaws."}));

// Faces of cracks and fragments that push each other away. Those of a closed crack bear pressure as
// the plate does, and slide freely (see crack_faces.hpp). Nodes that lack bonds and come too near,
// below `reach` times their distance at rest, push each other with `stiffness` times the
// micromodulus (see contact_forces.hpp), by default as in LAMMPS.
struct Contact {
  double stiffness = 15.0;
  double reach = 0.9;
};

template <>
inline constexpr auto description_of<Contact> = describe_noun(
    "contact", "contact",
    member("stiffness", &Contact::stiffness,
           {.range = above_up_to(0.0, 100.0),
            .fallback = "15",
            .sentence =
                "Of the repulsion of nodes that come too near, over that of a bond; the default "
                "is LAMMPS's."}),
    member("reach", &Contact::reach,
           {.range = above_up_to(0.0, 1.0),
            .fallback = "0.9",
            .sentence = "Nodes come too near below so much of their distance at rest, or of 1.5 "
                        "spacings if that is less."}));

// Thin, free of stress across its thickness, or thick, held from straining across it. Bond-based
// theory makes Poisson's ratio 1/3 in plane stress and 1/4 in plane strain
// (src/lattice/README.md 3.2).
enum class Plane { stress, strain };
template <>
inline constexpr auto enum_names<Plane> = std::to_array<std::string_view>({"stress", "strain"});

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
  std::vector<InitialCondition> initial_conditions;
  std::optional<Scatter> scatter;
  std::optional<Contact> contact;
  Loads loads;
};

template <>
inline constexpr auto description_of<Plate> = describe_noun(
    "plate", "plate",
    member("width", &Plate::width,
           {.unit = "m", .range = above(0.0), .required = true, .sentence = "Size along x."}),
    member("height", &Plate::height,
           {.unit = "m", .range = above(0.0), .required = true, .sentence = "Size along y."}),
    member("material", &Plate::material, {.required = true, .sentence = "What it is made of."}),
    member("plane", &Plate::plane,
           {.fallback = "stress",
            .sentence = "Plane stress for a thin plate, plane strain for a thick one."}),
    member("cutouts", &Plate::cutouts), member("inclusions", &Plate::inclusions),
    member("cracks", &Plate::cracks), member("no_fail", &Plate::no_fail),
    member("starts", &Plate::initial_conditions), member("strength", &Plate::scatter),
    member("contact", &Plate::contact), member("", &Plate::loads));

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
void check_no_fail(const Plate& plate, const Shape& zone, Problems& problems);

// "strength scattered (Weibull modulus 10, correlated over 2 mm, seed 1)"
std::string describe(const Scatter& scatter);

// "plate 100 x 40 mm, Duran 50 (E 65 GPa, ...), 1 crack, 2 tractions"; plane strain is said too.
std::string describe(const Plate& plate);

}  // namespace hackle
