// SPDX-License-Identifier: MIT
#include "measure/contour_integrals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "measure/derivatives.hpp"
#include "measure/node_window.hpp"
#include "solver/bond_visit.hpp"

namespace hackle {
namespace {

// The core of a moving crack, in horizons.
constexpr double core_radius = 1.5, core_width = 1.0;

constexpr std::array modes{FractureMode::opening, FractureMode::sliding};

// What an integral needs of one node. Derivatives are those ahead of the crack.
struct RingNode {
  Vec2 u_ahead{0, 0};       // of u
  double heat_ahead = 0.0;  // of the thermal strain, 1/m
  double kinetic = 0.0;     // J/m
  // Of Williams' fields of the two modes, turned to the axes of the plate.
  std::array<TipField, 2> singular{};
};

// The weights of one ring at the nodes of a window, and their derivatives ahead, 1/m, as
// differences of neighbours.
class RingWeights {
 public:
  RingWeights(const ContourRing& ring, const TipFrame& frame, const Grid& grid)
      : ring_(ring), frame_(frame), grid_(grid) {}

  double at(int i, int j) const { return ring_.weight((grid_.position(i, j) - frame_.tip).norm()); }
  double ahead(int i, int j) const {
    const Vec2 slope(at(i + 1, j) - at(i - 1, j), at(i, j + 1) - at(i, j - 1));
    return 0.5 * frame_.ahead.dot(slope) / grid_.dx;
  }

 private:
  ContourRing ring_;
  TipFrame frame_;
  Grid grid_;
};

struct Weight {
  double value = 0.0, ahead = 0.0;
};

class Integration {
 public:
  Integration(const View& view, const TipFrame& frame, const std::vector<ContourRing>& rings,
              const PlaneModuli& moduli)
      : view_(view),
        grid_(view.lattice().grid),
        frame_(frame),
        moduli_(moduli),
        window_(window_around(grid_, frame.tip, reach_of(rings))),
        count_(rings.size()),
        found_(rings.size()) {
    take_nodes();
    for (const ContourRing& ring : rings) take_weights(ring);
    const double horizon = view.numerics().horizon_or_default();
    has_core_ = is_moving();
    if (has_core_) take_weights({core_radius * horizon, core_width * horizon});
  }

  std::vector<RingIntegrals> integrals() {
    add_bonds();
    if (has_core_) add_kinetic();
    for (RingIntegrals& one : found_) {
      one.J -= core_.J;
      one.K_I = 0.5 * moduli_.stiffness() * (one.K_I - core_.K_I);
      one.K_II = 0.5 * moduli_.stiffness() * (one.K_II - core_.K_II);
    }
    return std::move(found_);
  }

 private:
  double reach_of(const std::vector<ContourRing>& rings) const {
    double reach = 0.0;
    for (const ContourRing& ring : rings) reach = std::max(reach, ring.outer());
    return reach + (view_.lattice().family.reach() + 1) * grid_.dx;
  }

  bool is_moving() const {
    return std::ranges::any_of(nodes_, [](const RingNode& node) { return node.kinetic > 0.0; });
  }

  void take_nodes() {
    const Derivatives derivatives(view_, frame_.ahead);
    const std::vector<double>& heat = view_.thermal_strain();
    nodes_.resize(window_.nodes());
    window_.for_each([&](int i, int j) {
      const Lattice& lattice = view_.lattice();
      if (lattice.is_void(i, j)) return;
      RingNode& node = nodes_[window_.index(i, j)];
      node.u_ahead = derivatives.of(i, j, [&](int k, int l) { return view_.displacement(k, l); });
      const double mass = lattice.material_at(i, j).material.rho * grid_.dx * grid_.dx;
      node.kinetic = 0.5 * mass * view_.velocity(i, j).squaredNorm();
      if (!heat.empty())
        node.heat_ahead =
            derivatives.of(i, j, [&](int k, int l) { return Vec2(heat[grid_.index(k, l)], 0.0); })
                .x();
      take_singular_fields(i, j, node);
    });
  }

  void take_singular_fields(int i, int j, RingNode& node) const {
    const Vec2 place = frame_.local(grid_.position(i, j));
    if (place.norm() < 0.5 * view_.numerics().horizon_or_default())
      return;  // no ring bond ends there
    for (std::size_t k = 0; k < modes.size(); ++k) {
      const TipField field = unit_field(modes[k], place, moduli_);
      node.singular[k] = {in_plate(field.u), in_plate(field.ahead)};
    }
  }
  Vec2 in_plate(const Vec2& local) const {
    return local.x() * frame_.ahead + local.y() * frame_.normal();
  }

  void take_weights(const ContourRing& ring) {
    const RingWeights weights(ring, frame_, grid_);
    window_.for_each([&](int i, int j) {
      weights_.push_back({weights.at(i, j), weights.ahead(i, j)});
    });
  }
  const Weight& weight(std::size_t ring, std::size_t node) const {
    return weights_[ring * window_.nodes() + node];
  }

  void add_bonds() {
    const auto keepers = [&](int a, int b, const auto& each) {
      window_.for_each([&](int i, int j) {
        if (window_.contains(i + a, j + b)) each(i, j);
      });
    };
    visit_bonds_kept(view_.lattice(), view_.state(), view_.thermal_strain(), keepers,
                     [&](const VisitedBond& bond) {
                       if (bond.holds) add_bond(bond);
                     });
  }

  std::size_t in_window(std::size_t node) const {
    const auto columns = static_cast<std::size_t>(grid_.nx);
    return window_.index(static_cast<int>(node % columns), static_cast<int>(node / columns));
  }

  // See src/measure/README.md 1.2 and 1.3.
  void add_bond(const VisitedBond& bond) {
    const std::size_t one = in_window(bond.one), other = in_window(bond.other);
    const RingNode &a = nodes_[one], &b = nodes_[other];
    const double volumes = std::pow(grid_.dx, 4);
    const double pull = bond.c * bond.weight * bond.s * volumes;         // N/m, on one by other
    const double energy = 0.5 * pull * bond.s * bond.length * grid_.dx;  // J/m
    const Vec2 force = pull * (bond.xi + bond.h).normalized();
    const double heat = 0.5 * pull * bond.length * grid_.dx / (1.0 + bond.s);
    for (std::size_t ring = 0; ring < count_; ++ring) {
      const Weight &p = weight(ring, one), &q = weight(ring, other);
      const double mean = 0.5 * (p.value + q.value), slope = 0.5 * (p.ahead + q.ahead);
      if (mean == 0.0 && slope == 0.0) continue;
      found_[ring].J += mean * force.dot(a.u_ahead - b.u_ahead) - slope * energy +
                        mean * heat * (a.heat_ahead + b.heat_ahead);
      add_interaction(bond, a, b, force, p, q, found_[ring]);
    }
    if (!has_core_) return;
    const double core_a = weight(count_, one).value, core_b = weight(count_, other).value;
    core_.J += force.dot(core_a * a.u_ahead - core_b * b.u_ahead);
    core_.K_I += force.dot(core_a * a.singular[0].ahead - core_b * b.singular[0].ahead);
    core_.K_II += force.dot(core_a * a.singular[1].ahead - core_b * b.singular[1].ahead);
  }

  // The singular fields are no equilibrium of the bonds: their forces count in the ring only.
  void add_interaction(const VisitedBond& bond, const RingNode& a, const RingNode& b,
                       const Vec2& force, const Weight& p, const Weight& q,
                       RingIntegrals& found) const {
    const double mean = 0.5 * (p.value + q.value), slope = 0.5 * (p.ahead + q.ahead);
    const double volumes = std::pow(grid_.dx, 4);
    const std::array<double*, 2> sums{&found.K_I, &found.K_II};
    for (std::size_t k = 0; k < modes.size(); ++k) {
      const TipField &at_a = a.singular[k], &at_b = b.singular[k];
      const double stretch = bond.xi.dot(at_b.u - at_a.u) / (grid_.dx * std::pow(bond.length, 2));
      const double pull = bond.c * bond.weight * stretch * volumes;
      const Vec2 pulled = 0.5 * pull / bond.length * bond.xi;
      *sums[k] += mean * force.dot(at_a.ahead - at_b.ahead) -
                  (p.value - q.value) * pulled.dot(a.u_ahead + b.u_ahead) -
                  slope * pull * bond.s * bond.length * grid_.dx;
    }
  }

  void add_kinetic() {
    for (std::size_t node = 0; node < nodes_.size(); ++node)
      core_.J += nodes_[node].kinetic * weight(count_, node).ahead;
  }

  const View& view_;
  const Grid& grid_;
  TipFrame frame_;
  PlaneModuli moduli_;
  NodeWindow window_;
  std::size_t count_;
  std::vector<RingNode> nodes_;  // of the window
  bool has_core_ = false;
  RingIntegrals core_;           // what is not to be counted of a plate in motion
  std::vector<Weight> weights_;  // likewise, ring after ring, at last that of the core
  std::vector<RingIntegrals> found_;
};

}  // namespace

double ContourRing::weight(double distance) const {
  const double t = std::clamp((distance - inner()) / width, 0.0, 1.0);
  return 0.5 * (1.0 + std::cos(std::numbers::pi * t));
}

std::vector<RingIntegrals> ring_integrals(const View& view, const TipFrame& frame,
                                          const std::vector<ContourRing>& rings,
                                          const PlaneModuli& moduli) {
  return Integration(view, frame, rings, moduli).integrals();
}

}  // namespace hackle
