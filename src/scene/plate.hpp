// SPDX-License-Identifier: MIT
// The user's description of a plate and everything on it. Exact geometry in SI units, without any
// mesh. Origin at the lower left corner, x right, y up. Quantities are per metre of thickness.
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
#include "scene/outline.hpp"
#include "scene/shape.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// Whether the bonds that a crack cuts count as damage, or never existed.
enum class Born { broken, absent };

template <>
inline constexpr auto enum_names<Born> = std::to_array<std::string_view>({"broken", "absent"});

// Whether the two ends of a crack belong to it: whether a bond that meets only an end is cut.
enum class CrackEnds { open, cut };

template <>
inline constexpr auto enum_names<CrackEnds> = std::to_array<std::string_view>({"open", "cut"});

// A crack of zero width along straight segments. It cuts every bond that shares a point with it;
// its two ends belong to it if it says so, or if they coincide. The rule holds under every mirror.
struct Crack {
  Crack() = default;
  Crack(const Vec2& from, const Vec2& to, Born how = Born::broken) : points{from, to}, born(how) {}
  Crack(std::vector<Vec2> along, Born how, CrackEnds tips = CrackEnds::open)
      : points(std::move(along)), born(how), ends(tips) {}

  std::vector<Vec2> points;  // m, on the plate; at least two
  Born born = Born::broken;
  CrackEnds ends = CrackEnds::open;
  std::string name;  // used by pressures to find its faces; "" for none
};

template <>
inline constexpr auto description_of<Crack> = describe_noun(
    "crack", "crack",
    member("points", &Crack::points,
           {.unit = "m",
            .range = between(2, max_points),
            .alternative = true,
            .sentence = "Points of a crack made of straight segments; it is closed if first and "
                        "last coincide."}),
    member("born", &Crack::born,
           {.fallback = "broken",
            .sentence = "Whether the bonds it cuts count as damage or never existed."}),
    member("ends", &Crack::ends,
           {.fallback = "open",
            .sentence = "Whether a bond that meets the crack only at its end is cut, as in "
                        "PDMATLAB2D, or stays."}),
    member("name", &Crack::name,
           {.alternative = true,
            .sentence = "Name for p:pressure to push its faces apart; several may share one."}));

// The treatment of bonds that pass through removed material.
enum class Bridging { cut, keep };

template <>
inline constexpr auto enum_names<Bridging> = std::to_array<std::string_view>({"cut", "keep"});

// Removed material: a hole or a notch. Nodes inside are void; bonds that pass through it are
// absent, or are kept, as in codes that only remove nodes.
struct Cutout {
  Shape shape;
  std::string name;  // used by loads to find this rim; "" for none
  Bridging bonds = Bridging::cut;
};

template <>
inline constexpr auto description_of<Cutout> = describe_noun(
    "cut-out", "cut-out", member("shape", &Cutout::shape, {.required = true}),
    member("name", &Cutout::name,
           {.alternative = true,
            .sentence = "Name for p:pressure and p:traction to find the rim; several rims may "
                        "share one."}),
    member("bonds", &Cutout::bonds,
           {.fallback = "cut",
            .sentence = "Whether bonds that pass through it are cut, or kept between the nodes on "
                        "either side."}));

// A region of another material. A node takes the material of the last inclusion that covers it.
struct Inclusion {
  Shape shape;
  Material material;
};

template <>
inline constexpr auto description_of<Inclusion> = describe_noun(
    "inclusion", "inclusion", member("shape", &Inclusion::shape, {.required = true}),
    member("material", &Inclusion::material, {.required = true, .sentence = "Its material."}));

// The scatter of strength over the plate: the critical stretch of a node is s0 times a factor of
// mean 1 drawn from a distribution. Correlated flaws are the same for every spacing.
struct Scatter {
  enum class Kind { weibull, normal };
  Kind kind = Kind::weibull;
  double spread = 0.0;       // Weibull modulus, or standard deviation of a normal distribution
  double correlation = 0.0;  // m; 0: nodes are independent
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
            .sentence =
                "Distribution of the critical stretch relative to the material's; its mean is 1."}),
    kind_member(
        &Scatter::kind, &Scatter::spread, std::to_array<std::string_view>({"modulus", "deviation"}),
        std::to_array<About>(
            {{.range = between(1.0, 1000.0),
              .required = true,
              .alternative = true,
              .sentence =
                  "Weibull modulus; 5 to 15 is usual for glass, a larger one scatters less."},
             {.range = above_up_to(0.0, 0.3),
              .required = true,
              .alternative = true,
              .sentence = "Standard deviation of a normal distribution, which is cut off at three.",
              .remedy = "use a Weibull distribution for larger scatter"}})),
    member("correlation", &Scatter::correlation,
           {.unit = "m",
            .range = at_least(0.0),
            .fallback = "0",
            .sentence = "Correlation length of strength; 0: nodes are independent, and the flaws "
                        "depend on the spacing."}),
    member("seed", &Scatter::seed,
           {.fallback = "1", .sentence = "Whole number; another one gives other flaws."}));

// Repulsion between faces of cracks and fragments. Faces of a closed crack bear pressure like the
// uncracked plate, and slide freely (see crack_faces.hpp). Nodes that lack bonds and come closer
// than `reach` times their initial distance repel each other with `stiffness` times the
// micromodulus (see contact_forces.hpp); the defaults are those of LAMMPS. What slides is resisted
// by `friction` times what presses it, and what rebounds keeps `restitution` of its speed.
struct Contact {
  double stiffness = 15.0;
  double reach = 0.9;
  double friction = 0.0;
  double restitution = 1.0;
};

template <>
inline constexpr auto description_of<Contact> = describe_noun(
    "contact", "contact",
    member("stiffness", &Contact::stiffness,
           {.range = above_up_to(0.0, 100.0),
            .fallback = "15",
            .sentence = "Stiffness of the repulsion between nodes too near each other, relative to "
                        "a bond's; the default is that of LAMMPS."}),
    member("reach", &Contact::reach,
           {.range = above_up_to(0.0, 1.0),
            .fallback = "0.9",
            .sentence = "Nodes are too near below this share of their initial distance, or of 1.5 "
                        "spacings if that is less."}),
    member("friction", &Contact::friction,
           {.range = between(0.0, 10.0),
            .fallback = "0",
            .sentence = "Coefficient of friction of faces and fragments that press."}),
    member("restitution", &Contact::restitution,
           {.range = between(0.0, 1.0),
            .fallback = "1",
            .sentence = "Speed after a rebound over that before it, apart from what waves carry "
                        "away."}));

// Plane stress: thin, without stress across the thickness. Plane strain: thick, without strain
// across it. Bond-based theory makes Poisson's ratio 1/3 in plane stress and 1/4 in plane strain
// (src/lattice/README.md 3.2).
enum class Plane { stress, strain };
template <>
inline constexpr auto enum_names<Plane> = std::to_array<std::string_view>({"stress", "strain"});

struct Plate {
  double width = 0.0;   // m, along x, > 0
  double height = 0.0;  // m, along y, > 0
  Material material;
  Plane plane = Plane::stress;
  std::vector<Outline> outlines;  // a node is kept if all of them cover it
  std::vector<Cutout> cutouts;
  std::vector<Inclusion> inclusions;  // at most 254
  std::vector<Crack> cracks;
  // Regions, rims included, in which bonds never break; one end inside is enough.
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
    member("material", &Plate::material, {.required = true, .sentence = "Its material."}),
    member("plane", &Plate::plane,
           {.fallback = "stress",
            .sentence = "Plane stress for a thin plate, plane strain for a thick one."}),
    member("outlines", &Plate::outlines), member("cutouts", &Plate::cutouts),
    member("inclusions", &Plate::inclusions), member("cracks", &Plate::cracks),
    member("no_fail", &Plate::no_fail), member("starts", &Plate::initial_conditions),
    member("strength", &Plate::scatter), member("contact", &Plate::contact),
    member("", &Plate::loads));

// Returns 0 without contact.
double contact_stiffness(const Plate& plate);

// Returns the strip of width `depth` along an edge.
Shape strip(const Plate& plate, Edge edge, double depth);

// Adds a problem for everything invalid in the plate (or in one noun that is to be added to it):
// sizes, materials, cracks without length or off the plate, zones off the plate, stresses that are
// not finite.
void check(const Plate& plate, Problems& problems);
void check(const Plate& plate, const Crack& crack, Problems& problems);
// `who` names the calling function in messages: "hole".
void check(const Plate& plate, const Shape& shape, const std::string& who, Problems& problems);
// Also checks that the cut-out leaves a part of the plate.
void check_cutout(const Plate& plate, const Shape& shape, const std::string& who,
                  Problems& problems);
// Also checks that the outline keeps a part of the plate.
void check(const Plate& plate, const Outline& outline, Problems& problems);
void check_no_fail(const Plate& plate, const Shape& zone, Problems& problems);

// Returns "strength scattered (Weibull modulus 10, correlated over 2 mm, seed 1)".
std::string describe(const Scatter& scatter);

// Returns "plate 100 x 40 mm, Duran 50 (E 65 GPa, ...), 1 crack, 2 tractions"; mentions plane
// strain.
std::string describe(const Plate& plate);

}  // namespace hackle
