// SPDX-License-Identifier: MIT
#include "lattice/rim_shares.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "lattice/load_map.hpp"
#include "support/composite.hpp"

namespace hackle {
namespace {

constexpr double rim_spacing = 0.5e-3;
constexpr double right_angle = 0.5 * std::numbers::pi;

// Chords in place of arcs cost 4e-7 of the length, and up to a millionth of the radius where an arc
// is cut, at either end (see arc() in geometry.hpp).
constexpr double exact = 2e-6;

double length_of(const std::vector<RimShare>& shares) {
  double sum = 0.0;
  for (const RimShare& share : shares) sum += share.length * rim_spacing;
  return sum;
}

Vec2 normal_of(const std::vector<RimShare>& shares) {
  Vec2 sum(0.0, 0.0);
  for (const RimShare& share : shares) sum += share.normal * rim_spacing;
  return sum;
}

// A plate of 20 by 20 mm.
struct Rims {
  Rims() {
    plate.cutouts.push_back({test::disc(centre, radius), "bore"});
    plate.cutouts.push_back({rectangle({14e-3, 2e-3}, {18e-3, 5e-3}), "box"});
  }
  std::vector<RimShare> shares(const std::string& name, const RimPart& angles = {}) const {
    return shares_of_rims(plate, Lattice(plate, test::numerics(rim_spacing)), name, angles);
  }
  Vec2 centre{9.3e-3, 11.1e-3};
  double radius = 5.17e-3;
  Plate plate = test::bare_plate(40, 40);
};

TEST(RimShares, AreTheLengthOfTheRimAndItsNormalsAddUpToNothing) {
  const Rims rims;
  const double around = 2.0 * std::numbers::pi * rims.radius;
  EXPECT_NEAR(length_of(rims.shares("bore")), around, exact * around);
  EXPECT_NEAR(normal_of(rims.shares("bore")).norm(), 0.0, exact * around);
  EXPECT_NEAR(length_of(rims.shares("box")), 14e-3, exact * 14e-3);
  EXPECT_TRUE(rims.shares("other").empty());
}

// Of an arc from a to b: length R (b - a), integral of the normal R (sin b - sin a, cos a - cos b).
TEST(RimShares, OfAnArcHaveItsLengthAndResultant) {
  const Rims rims;
  for (const auto& [from, to] : {std::pair{0.2, 0.9}, {-0.5, 2.9}, {3.0, 4.5}, {6.2, 6.5}}) {
    const std::vector<RimShare> shares = rims.shares("bore", Vec2(from, to));
    const double size = exact * rims.radius;
    EXPECT_NEAR(length_of(shares), rims.radius * (to - from), size);
    const Vec2 wanted =
        rims.radius * Vec2(std::sin(to) - std::sin(from), std::cos(from) - std::cos(to));
    EXPECT_NEAR((normal_of(shares) - wanted).norm(), 0.0, size) << from;
    EXPECT_EQ(length_of(rims.shares("bore", Vec2(to, from))), length_of(shares));
  }
}

TEST(RimShares, GoToNodesOfTheMaterialNextToTheRim) {
  const Rims rims;
  const Lattice lattice(rims.plate, test::numerics(rim_spacing));
  for (const RimShare& share : shares_of_rims(rims.plate, lattice, "bore", {})) {
    EXPECT_FALSE(lattice.is_void(share.i, share.j));
    const Vec2 from_rim = lattice.grid.position(share.i, share.j) - share.middle;
    EXPECT_LT(from_rim.norm(), 1.5 * rim_spacing);
    EXPECT_GT(share.normal.dot(share.middle - rims.centre), 0.0);  // into the material
    EXPECT_NEAR((share.middle - rims.centre).norm(), rims.radius, 0.1 * rim_spacing);
    EXPECT_LT(share.length, 2.0);
  }
}

TEST(RimShares, OfAnOutlinePointInwards) {
  Plate plate = test::bare_plate(40, 40);
  plate.outlines = {{{test::disc({10e-3, 10e-3}, 10e-3)}, "rim"}};
  const Lattice lattice(plate, test::numerics(rim_spacing));
  const auto top = shares_of_rims(plate, lattice, "rim", Vec2(0.8, 1.2) * right_angle);
  EXPECT_NEAR(length_of(top), 0.4 * right_angle * 10e-3, exact * 10e-3);
  EXPECT_NEAR(normal_of(top).y(), -2.0 * 10e-3 * std::sin(0.2 * right_angle), exact * 10e-3);
  EXPECT_NEAR(normal_of(top).x(), 0.0, exact * 10e-3);
}

// What two holes have in common is one rim, and what lies in another hole or off the plate is none.
TEST(RimShares, CountNoPartTwiceAndNoneWithoutMaterial) {
  Plate plate = test::bare_plate(40, 40);
  plate.cutouts.push_back({rectangle({4e-3, 4e-3}, {8e-3, 8e-3}), "a"});
  plate.cutouts.push_back({rectangle({4e-3, 4e-3}, {8e-3, 12e-3}), "a"});  // on three sides of it
  plate.cutouts.push_back({rectangle({6e-3, 10e-3}, {12e-3, 11e-3}), ""});
  plate.cutouts.push_back({rectangle({16e-3, 4e-3}, {25e-3, 8e-3}), "b"});
  const Lattice lattice(plate, test::numerics(rim_spacing));
  EXPECT_NEAR(length_of(shares_of_rims(plate, lattice, "a", {})), 2 * (4e-3 + 8e-3) - 1e-3, 1e-9);
  EXPECT_NEAR(length_of(shares_of_rims(plate, lattice, "b", {})), 4e-3 + 2 * 4e-3, 1e-9);
}

TEST(RimShares, OfACrackPushItsFacesApart) {
  Plate plate = test::bare_plate(40, 40);
  Crack crack({3.1e-3, 10e-3}, {12.7e-3, 10e-3});
  crack.name = "slit";
  plate.cracks = {crack};
  const Lattice lattice(plate, test::numerics(rim_spacing));
  const auto shares = shares_of_cracks(plate, lattice, "slit", {});
  EXPECT_NEAR(length_of(shares), 2 * 9.6e-3, 1e-9);
  EXPECT_NEAR(normal_of(shares).norm(), 0.0, 1e-12);
  double up = 0.0;
  for (const RimShare& share : shares) {
    EXPECT_TRUE(share.j == 19 || share.j == 20) << share.j;
    EXPECT_EQ(share.normal, Vec2(0.0, share.j == 20 ? share.length : -share.length));
    up += std::max(0.0, share.normal.y() * rim_spacing);
  }
  EXPECT_NEAR(up, 9.6e-3, 1e-9);
}

// Nodes on a crack belong to neither face.
TEST(RimShares, OfACrackThroughNodesGoToTheNodesBeside) {
  Plate plate = test::bare_plate(40, 41);
  Crack crack({3e-3, 10.25e-3}, {12e-3, 10.25e-3});
  crack.name = "slit";
  plate.cracks = {crack};
  const Lattice lattice(plate, test::numerics(rim_spacing));
  const auto shares = shares_of_cracks(plate, lattice, "slit", {});
  EXPECT_NEAR(length_of(shares), 2 * 9e-3, 1e-9);
  for (const RimShare& share : shares) EXPECT_TRUE(share.j == 19 || share.j == 21) << share.j;
}

TEST(RimShares, OfASceneThatIsItsOwnMirrorImageAreSo) {
  Plate plate = test::bare_plate(40, 40);
  plate.cutouts.push_back({Ellipse{{10e-3, 10e-3}, {6.1e-3, 3.7e-3}, 0.0}, "bore"});
  const Lattice lattice(plate, test::numerics(rim_spacing));
  const auto shares = shares_of_rims(plate, lattice, "bore", {});
  for (const RimShare& one : shares) {
    const auto image = std::ranges::find_if(
        shares, [&](const RimShare& other) { return other.i == 39 - one.i && other.j == one.j; });
    ASSERT_NE(image, shares.end());
    EXPECT_EQ(image->length, one.length);
    EXPECT_EQ(image->normal, Vec2(-one.normal.x(), one.normal.y()));
  }
}

// The loads that act along rims.

// N per metre of thickness, of the first load.
Vec2 force_on_rims(const Plate& plate) {
  const Lattice lattice(plate, test::numerics(rim_spacing));
  Vec2 force(0.0, 0.0);
  const std::vector<SpreadForce> forces = spread_forces(plate, lattice);
  for (const LoadedNode& load : forces.front().nodes)
    force += load.inertia * lattice.rho * load.acceleration * rim_spacing * rim_spacing;
  return force;
}

TEST(RimLoads, HaveTheResultantOfTheirArc) {
  Rims rims;
  Traction traction;
  traction.stress = Vec2(2e6, -3e6);
  traction.rim = "bore";
  traction.angles = Vec2(0.7, 1.9);
  rims.plate.loads.tractions = {traction};
  const double arc = rims.radius * 1.2;
  EXPECT_NEAR((force_on_rims(rims.plate) - arc * Vec2(2e6, -3e6)).norm(), 0.0, exact * arc * 4e6);
  rims.plate.loads.tractions.clear();
  rims.plate.loads.pressures = {{"bore", 5e6, {}, Vec2(0.0, 2.0 * right_angle)}};
  EXPECT_NEAR(force_on_rims(rims.plate).y(), 5e6 * 2.0 * rims.radius, exact * 5e6 * 0.02);
  rims.plate.loads.pressures[0].angles = Vec2(-1.0, -1.0 + 4.0 * right_angle);
  EXPECT_NEAR(force_on_rims(rims.plate).norm(), 0.0, exact * 5e6 * 0.02);
}

// By a function of place: x on a closed rim integrates to its length times the middle.
TEST(RimLoads, TakeTheStressOfTheirPlace) {
  Rims rims;
  Traction traction;
  traction.stress = VectorField(
      std::function<Vec2(const Vec2&)>([](const Vec2& place) { return Vec2(1e9 * place); }));
  traction.rim = "bore";
  rims.plate.loads.tractions = {traction};
  const double around = 2.0 * std::numbers::pi * rims.radius;
  EXPECT_NEAR((force_on_rims(rims.plate) - 1e9 * around * rims.centre).norm(), 0.0,
              exact * 1e9 * around * rims.centre.norm());
}

TEST(RimLoads, MayVaryInPlaceAndTime) {
  Rims rims;
  Traction traction;
  traction.stress = VectorField(std::function<Vec2(const Vec2&, double)>(
      [](const Vec2& place, double t) { return Vec2(t * place); }));
  traction.rim = "bore";
  rims.plate.loads.tractions = {traction};
  const Lattice lattice(rims.plate, test::numerics(rim_spacing));
  const SpreadForce force = spread_forces(rims.plate, lattice).at(0);
  const std::vector<Vec2> early = values_at(force.course, 2.0), late = values_at(force.course, 6.0);
  ASSERT_EQ(early.size(), force.nodes.size());
  for (std::size_t k = 0; k < early.size(); ++k) {
    EXPECT_EQ(force.nodes[k].acceleration, Vec2(0.0, 0.0));  // at t = 0
    EXPECT_NEAR((late[k] - 3.0 * early[k]).norm(), 0.0, 1e-12 * late[k].norm());
  }
}

}  // namespace
}  // namespace hackle
