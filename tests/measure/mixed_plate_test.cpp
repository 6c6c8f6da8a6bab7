// SPDX-License-Identifier: MIT
// Compares every field and every energy of a plate with all features, node by node, with sums over
// pairs of nodes written down a second time: glass with steel, resin and a hole, of uneven strength
// and temperature, displaced, moving, with broken bonds.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>

#include <gtest/gtest.h>

#include "measure/bond_field.hpp"
#include "measure/energy.hpp"
#include "measure/field.hpp"
#include "measure/scalar.hpp"
#include "support/composite.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

constexpr int columns = 34, rows = 22, m = 3;
constexpr double dx = 0.5e-3;

// The material of a node, by its position.
enum Kind { glass, soft, hard, nothing };

Kind kind_at(int i, int j) {
  const Vec2 at = dx * Vec2(i + 0.5, j + 0.5);
  if ((at - Vec2(14e-3, 5e-3)).norm() < 1.6e-3) return nothing;
  if (at.x() < 4e-3) return soft;
  return at.y() > 8e-3 ? hard : glass;
}

Material material_of(Kind kind) {
  Material material = kind == soft ? test::resin() : kind == hard ? test::steel() : test::duran50();
  if (kind == glass) material.alphaT = 4e-6;
  material.fringe = kind == soft ? 20e3 : kind == hard ? 7e3 : 136.5e3;
  return material;
}

Vec2 warmth(int i, int j) {  // K, from two changes
  return {3.0 * dx * i / 1e-3, 20.0 - 1.5 * j};
}

Plate mixed_plate(Plane plane) {
  Plate plate = test::bare_plate(columns, rows);  // 17 x 11 mm
  plate.plane = plane;
  plate.material = material_of(glass);
  plate.inclusions.push_back({rectangle({0, 8e-3}, {20e-3, 11e-3}), material_of(hard)});
  plate.inclusions.push_back({rectangle({0, 0}, {4e-3, 11e-3}), material_of(soft)});
  plate.cutouts.push_back({Ellipse{{14e-3, 5e-3}, {1.6e-3, 1.6e-3}, 0.0}, ""});
  plate.scatter = Scatter{Scatter::Kind::normal, 0.2, 0.0, 5};
  const auto index = [](double x) { return static_cast<int>(x / dx); };
  plate.loads.thermal_loads.push_back(
      {{},
       ScalarField([index](const Vec2& x) { return warmth(index(x.x()), index(x.y())).x(); }),
       {}});
  plate.loads.thermal_loads.push_back(
      {{},
       ScalarField([index](const Vec2& x) { return warmth(index(x.x()), index(x.y())).y(); }),
       {}});
  plate.cracks.push_back({{9e-3, 3e-3}, {12e-3, 7e-3}, Born::broken});
  return plate;
}

Simulation mixed(Plane plane) {
  Simulation simulation(mixed_plate(plane), test::numerics(dx, m * dx), {1});
  State state = test::jolted(simulation.state(), 2e-4, 3);
  state = test::shaken(std::move(state), 1e-3, 4);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      if (kind_at(i, j) == nothing) state.set_v(i, j, {0, 0});  // it never moves
  // A cut through the whole plate and a node without bonds, as if the bonds had broken in a run.
  Plate cut = mixed_plate(plane);
  cut.cracks.push_back({{6.1e-3, 0.0}, {6.4e-3, 11e-3}, Born::broken});
  state.bonds = Lattice(cut, simulation.numerics()).bonds;
  isolate(simulation.lattice().grid, simulation.lattice().family, 25, 18, state.bonds);
  simulation.restore(std::move(state));
  return simulation;
}

// Computes the same by plain loops over pairs.
class ByHand {
 public:
  explicit ByHand(const Simulation& simulation) : simulation_(simulation) {
    for (const Kind kind : {glass, soft, hard}) {
      Plate pure = test::bare_plate(20, 20);
      pure.plane = simulation.plate().plane;
      pure.material = material_of(kind);
      calibrations_[kind] = Lattice(pure, simulation.numerics()).calibration;
    }
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
        for (int b = -m; b <= m; ++b)
          for (int a = -m; a <= m; ++a)
            if ((a != 0 || b != 0) && a * a + b * b <= m * m) add_bond(i, j, a, b);
  }

  double at(const std::string& field, int i, int j) const {
    const auto node = static_cast<std::size_t>(j * columns + i);
    const Kind kind = kind_at(i, j);
    const Material material = material_of(kind);
    const Vec2 u = kind == nothing ? Vec2(0, 0) : Vec2(dx * simulation_.state().u(i, j));
    const Vec2 v = kind == nothing ? Vec2(0, 0) : speed(i, j);
    const double xx = xx_[node], yy = yy_[node], xy = xy_[node];
    // The roots of the characteristic polynomial.
    const double trace = xx + yy, root = std::sqrt(trace * trace - 4.0 * (xx * yy - xy * xy));
    if (field == "damage") return born_[node] == 0 ? 0.0 : 1.0 - double(left_[node]) / born_[node];
    if (field == "displacement") return std::hypot(u.x(), u.y());
    if (field == "displacement_x") return u.x();
    if (field == "displacement_y") return u.y();
    if (field == "speed") return std::hypot(v.x(), v.y());
    if (field == "velocity_x") return v.x();
    if (field == "velocity_y") return v.y();
    if (field == "stretch") return left_[node] == 0 ? 0.0 : closest_[node];
    if (field == "energy_density") return energy_[node];
    if (field == "stress_xx") return xx;
    if (field == "stress_yy") return yy;
    if (field == "stress_xy") return xy;
    if (field == "stress_1") return 0.5 * (trace + root);
    if (field == "stress_2") return 0.5 * (trace - root);
    if (field == "stress_mean") return 0.5 * trace;
    if (field == "shear") return 0.5 * root;
    if (field == "von_mises") return von_mises(xx, yy, xy, across(i, j, xx, yy));
    if (field == "fringes") return kind == nothing ? 0.0 : root / material.fringe;
    if (field == "fragments") return piece(i, j);
    if (field == "strength") return simulation_.lattice().strength[node];
    if (field == "temperature") return kind == nothing ? 0.0 : warmth(i, j).sum();
    ADD_FAILURE() << "no sum for " << field;
    return 0.0;
  }

  double kinetic() const {
    double sum = 0.0;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
        if (kind_at(i, j) != nothing)
          sum += 0.5 * material_of(kind_at(i, j)).rho * dx * dx * speed(i, j).squaredNorm();
    return sum;
  }
  double strain() const { return dx * dx * std::accumulate(energy_.begin(), energy_.end(), 0.0); }
  double broken() const { return broken_; }
  int lost() const { return lost_; }

 private:
  // At a start both u and v belong to the same time.
  Vec2 speed(int i, int j) const { return simulation_.state().v(i, j) * (dx / simulation_.dt()); }
  double heat(int i, int j) const { return material_of(kind_at(i, j)).alphaT * warmth(i, j).sum(); }
  double across(int i, int j, double xx, double yy) const {
    if (simulation_.plate().plane == Plane::stress || kind_at(i, j) == nothing) return 0.0;
    const Moduli& moduli = calibrations_.at(kind_at(i, j)).moduli;
    return moduli.C12 / (moduli.C11 + moduli.C12) * (xx + yy) -
           material_of(kind_at(i, j)).E * heat(i, j);
  }
  static double von_mises(double xx, double yy, double xy, double zz) {
    return std::sqrt(0.5 * (std::pow(xx - yy, 2) + std::pow(yy - zz, 2) + std::pow(zz - xx, 2)) +
                     3.0 * xy * xy);
  }
  // Returns the fragment: left of the cut, right of it, or single.
  static double piece(int i, int j) {
    if (kind_at(i, j) == nothing || (i == 25 && j == 18)) return 0.0;
    const double cut = 6.1e-3 + 0.3e-3 * (j + 0.5) * dx / 11e-3;
    return (i + 0.5) * dx > cut ? 1.0 : 2.0;
  }

  void add_bond(int i, int j, int a, int b) {
    const int k = i + a, l = j + b;
    if (k < 0 || l < 0 || k >= columns || l >= rows) return;
    const Lattice& lattice = simulation_.lattice();
    const Grid& grid = lattice.grid;
    const auto one = static_cast<std::size_t>(j * columns + i),
               two = static_cast<std::size_t>(l * columns + k);
    const bool in_scene = holds(grid, lattice.family, lattice.bonds, i, j, a, b);
    const bool cut_away =
        kind_at(i, j) == nothing || kind_at(k, l) == nothing || passes_hole(i, j, a, b);
    born_[one] += cut_away ? 0 : 1;
    if (!in_scene) return;
    const Calibration &p = calibrations_.at(kind_at(i, j)), &q = calibrations_.at(kind_at(k, l));
    const double c = 0.5 * (p.c + q.c), V = dx * dx, length = dx * std::hypot(a, b);
    const double s0 = std::min(p.s0 * lattice.strength[one], q.s0 * lattice.strength[two]);
    if (!holds(grid, lattice.family, simulation_.state().bonds, i, j, a, b)) {
      broken_ += 0.25 * c * length * V * V * s0 * s0;  // counted from either end
      lost_ += 1;
      return;
    }
    left_[one] += 1;
    const Vec2 eta = dx * (simulation_.state().u(k, l) - simulation_.state().u(i, j));
    const long double x = dx * a + static_cast<long double>(eta.x()),
                      y = dx * b + static_cast<long double>(eta.y());
    const long double ratio = (x * x + y * y) / (static_cast<long double>(length) * length);
    const auto s = static_cast<double>(std::sqrt(ratio - heat(i, j) - heat(k, l)) - 1.0L);
    const double pull = 0.5 * c * s * V / length * dx * dx;  // 1/2 c s V |xi| e x e
    xx_[one] += pull * a * a;
    yy_[one] += pull * b * b;
    xy_[one] += pull * a * b;
    energy_[one] += 0.25 * c * s * s * length * V;
    closest_[one] = std::max(closest_[one], s / s0);
  }
  // Checks the point of the bond nearest to the centre of the hole.
  static bool passes_hole(int i, int j, int a, int b) {
    const Vec2 from = dx * Vec2(i + 0.5, j + 0.5) - Vec2(14e-3, 5e-3), along = dx * Vec2(a, b);
    const double share = std::clamp(-from.dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (from + share * along).norm() < 1.6e-3;
  }

  const Simulation& simulation_;
  std::map<Kind, Calibration> calibrations_;
  std::vector<double> xx_ = std::vector<double>(columns * rows), yy_ = xx_, xy_ = xx_,
                      energy_ = xx_;
  std::vector<double> closest_ = std::vector<double>(columns * rows, -1e300);
  std::vector<int> born_ = std::vector<int>(columns * rows), left_ = born_;
  double broken_ = 0.0;
  int lost_ = 0;
};

class MixedPlate : public testing::TestWithParam<Plane> {};

// Tolerance: the rounding of single precision, relative to the largest value of the field.
TEST_P(MixedPlate, HasEveryFieldAtEveryNode) {
  const Simulation simulation = mixed(GetParam());
  const ByHand sums(simulation);
  for (const Scalar& scalar : scalars()) {
    const std::vector<float> found = scalar.values(simulation);
    const std::string name(scalar.name);
    float max = 0.0F;
    for (const float value : found) max = std::max(max, std::abs(value));
    EXPECT_GT(max, 0.0F) << name;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
        ASSERT_NEAR(found[static_cast<std::size_t>(j * columns + i)], sums.at(name, i, j),
                    2e-7 * max)
            << name << " at " << i << ", " << j;
  }
}

// What is asked of one node is what the fields of the whole plate have there.
TEST_P(MixedPlate, OneNodeSaysTheSameAsTheWholePlate) {
  const Simulation simulation = mixed(GetParam());
  const std::vector<Stress> stress = stresses(simulation);
  const std::vector<double> energy = energy_densities(simulation);
  const std::vector<double> closest = closest_to_breaking(simulation);
  const std::vector<float> damages = damage(simulation).values;
  const std::vector<float> temperatures = scalar_of("temperature").values(simulation);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const std::size_t at = simulation.lattice().grid.index(i, j);
      const BondsOfNode own = bonds_of_node(simulation, i, j);
      EXPECT_DOUBLE_EQ(own.stress.xx, stress[at].xx) << i << " " << j;
      EXPECT_DOUBLE_EQ(own.stress.yy, stress[at].yy);
      EXPECT_DOUBLE_EQ(own.stress.xy, stress[at].xy);
      EXPECT_DOUBLE_EQ(own.stress.zz, stress[at].zz);
      EXPECT_DOUBLE_EQ(own.energy, energy[at]);
      EXPECT_DOUBLE_EQ(own.closeness, closest[at]);
      EXPECT_FLOAT_EQ(static_cast<float>(damage_of(simulation, i, j)), damages[at]);
      EXPECT_FLOAT_EQ(static_cast<float>(temperature_of(simulation, i, j)), temperatures[at]);
    }
}

TEST_P(MixedPlate, HasItsEnergies) {
  const Simulation simulation = mixed(GetParam());
  const ByHand sums(simulation);
  const Energy ledger = energy(simulation);
  EXPECT_NEAR(ledger.kinetic, sums.kinetic(), 1e-12 * sums.kinetic());
  EXPECT_NEAR(ledger.strain, sums.strain(), 1e-10 * sums.strain());
  EXPECT_NEAR(ledger.broken, sums.broken(), 1e-10 * sums.broken());
  EXPECT_EQ(2 * count_damage(simulation).broken_bonds, sums.lost());
  EXPECT_GT(sums.lost(), 200);
}

INSTANTIATE_TEST_SUITE_P(Planes, MixedPlate, testing::Values(Plane::stress, Plane::strain));

// Between walls on all sides the stress in the plate is known; across it is nu times the sum.
TEST(VonMises, CountsTheStressAcrossAThickPlate) {
  const auto pressed = [](Plane plane) {
    Plate plate = test::bare_plate(24, 20);
    plate.plane = plane;
    Simulation simulation(plate, test::numerics(), {1});
    simulation.restore(test::displaced(simulation, [](const Vec2& x) { return Vec2(-1e-6 * x); }));
    return scalar_of("von_mises").values(simulation)[10 * 24 + 12];
  };
  // Both principal stresses in the plate are K e; that across it is nu times their sum.
  const auto wanted = [](Plane plane) {
    Plate plate = test::bare_plate(24, 20);
    plate.plane = plane;
    const Moduli moduli = Lattice(plate, test::numerics()).calibration.moduli;
    const double in_plane = 1e-6 * (moduli.C11 + moduli.C12);
    const double nu = moduli.C12 / (moduli.C11 + moduli.C12);
    return plane == Plane::stress ? in_plane : (1.0 - 2.0 * nu) * in_plane;
  };
  for (const Plane plane : {Plane::stress, Plane::strain})
    EXPECT_NEAR(pressed(plane), wanted(plane), 1e-5 * wanted(plane));
}

}  // namespace
}  // namespace hackle
