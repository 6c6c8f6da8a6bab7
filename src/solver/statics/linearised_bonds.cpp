// SPDX-License-Identifier: MIT
#include "solver/statics/linearised_bonds.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace hackle {
namespace {

// Coinciding nodes must not divide by zero; as in the kernels.
constexpr double no_length = 1e-12;

// Quantities of a deformed bond: y = xi + h, e = (|y|/L)^2 - 1 without cancellation, minus the
// thermal part.
struct Deformed {
  Deformed(const Vec2& xi, double inverse_length, const Vec2& h, double heat)
      : y(xi + h),
        e((h.x() * (h.x() + 2.0 * xi.x()) + h.y() * (h.y() + 2.0 * xi.y())) *
              (inverse_length * inverse_length) -
          heat),
        squared(std::max(1.0 + e, no_length)),
        ratio(std::sqrt(squared)) {}

  double g() const { return e / (squared + ratio); }  // s/(1+s)
  double stretch() const { return e / (1.0 + ratio); }

  Vec2 y;
  double e, squared, ratio;
};

}  // namespace

NodeVectors displacements_of(const State& state) {
  NodeVectors u(state.layout);
  for (int j = 0; j < state.layout.ny; ++j)
    for (int i = 0; i < state.layout.nx; ++i) {
      const auto at = static_cast<std::size_t>(state.layout.at(i, j));
      const Vec2 value = state.u(i, j);
      u.x[at] = value.x();
      u.y[at] = value.y();
    }
  return u;
}

LinearisedBonds::LinearisedBonds(const Lattice& lattice, const State& state, Threads threads,
                                 std::span<const double> heat)
    : lattice_(&lattice),
      state_(&state),
      threads_(std::move(threads)),
      heat_(heat),
      unit_(lattice.calibration.c * lattice.grid.dx * lattice.grid.dx) {
  lattice.family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int bit) {
    if (a >= 0) images_.push_back(kept_.size());
    kept_.push_back({a, b, xi, weight, 1.0 / xi.norm(), bit});
  });
}

bool LinearisedBonds::holds(int i, int j, const Kept& bond) const {
  return state_->bonds.holds(layout().at(i, j), bond.bit);
}

bool LinearisedBonds::has_bonds(int i, int j) const {
  bool any = false;
  for_each_neighbour(i, j, [&](int, int) { any = true; });
  return any;
}

double LinearisedBonds::strength_of(int i, int j, const Kept& bond) const {
  if (lattice_->material.empty() && lattice_->surface.empty()) return bond.weight;
  const double sum =
      lattice_->micromodulus_at(i, j) + lattice_->micromodulus_at(i + bond.a, j + bond.b);
  return bond.weight * (0.5 * sum / lattice_->calibration.c);
}

double LinearisedBonds::heat_of(int i, int j, const Kept& bond) const {
  if (heat_.empty()) return 0.0;
  const Grid& grid = lattice_->grid;
  return heat_[grid.index(i, j)] + heat_[grid.index(i + bond.a, j + bond.b)];
}

double LinearisedBonds::stretch_of(const NodeVectors& u, int i, int j, const Kept& bond) const {
  const auto from = static_cast<std::size_t>(layout().at(i, j));
  const auto to = static_cast<std::size_t>(layout().at(i + bond.a, j + bond.b));
  return Deformed(bond.xi, bond.inverse_length, {u.x[to] - u.x[from], u.y[to] - u.y[from]},
                  heat_of(i, j, bond))
      .stretch();
}

Stiffness LinearisedBonds::stiffness_of(const NodeVectors& u, int i, int j, const Kept& bond,
                                        Tangent tangent) const {
  const auto from = static_cast<std::size_t>(layout().at(i, j));
  const auto to = static_cast<std::size_t>(layout().at(i + bond.a, j + bond.b));
  const Deformed deformed(bond.xi, bond.inverse_length, {u.x[to] - u.x[from], u.y[to] - u.y[from]},
                          heat_of(i, j, bond));
  const double pull = strength_of(i, j, bond) * bond.inverse_length;
  const double across =
      pull * (tangent == Tangent::positive ? std::max(deformed.g(), 0.0) : deformed.g());
  const double along =
      pull * (bond.inverse_length * bond.inverse_length) / (deformed.squared * deformed.ratio);
  const Vec2& y = deformed.y;
  return {across + along * (y.x() * y.x()), along * (y.x() * y.y()),
          across + along * (y.y() * y.y())};
}

// Computes the force on each node of row j by the bonds of one image: those that the row keeps, or
// those that other rows keep to it.
void LinearisedBonds::pull_row(const NodeVectors& u, int j, const Kept& bond, bool keeps, double* x,
                               double* y) const {
  const Grid& grid = lattice_->grid;
  std::fill_n(x, grid.nx, 0.0);
  std::fill_n(y, grid.nx, 0.0);
  const int row = keeps ? j : j - bond.b;
  if (row < 0 || row + bond.b >= grid.ny) return;
  const std::ptrdiff_t from = layout().at(0, row), to = layout().at(bond.a, row + bond.b);
  const double *x_from = u.x.data() + from, *x_to = u.x.data() + to;
  const double *y_from = u.y.data() + from, *y_to = u.y.data() + to;
  const std::uint32_t* words = state_->bonds.words().data() +
                               static_cast<std::size_t>(bond.bit / 32) * state_->bonds.plane() +
                               from;
  const double sign = keeps ? 1.0 : -1.0;
  const int end = std::min(grid.nx, grid.nx - bond.a), shift = keeps ? 0 : bond.a;
  for (int i = std::max(0, -bond.a); i < end; ++i) {
    const Deformed deformed(bond.xi, bond.inverse_length,
                            {x_to[i] - x_from[i], y_to[i] - y_from[i]}, heat_of(i, row, bond));
    const bool held = ((words[i] >> (bond.bit % 32)) & 1U) != 0;
    const double pull =
        held ? sign * (strength_of(i, row, bond) * bond.inverse_length * deformed.g()) : 0.0;
    x[i + shift] = pull * deformed.y.x();
    y[i + shift] = pull * deformed.y.y();
  }
}

// Images of an offset are summed in the order of the engine: the forces of a mirror-symmetric scene
// are symmetric to the last bit.
void LinearisedBonds::forces(const NodeVectors& u, NodeVectors& force) const {
  const auto nx = static_cast<std::size_t>(lattice_->grid.nx);
  for_rows(threads_, lattice_->grid.ny, [&](int j) {
    const auto first = static_cast<std::size_t>(layout().at(0, j));
    double *x = &force.x[first], *y = &force.y[first];
    std::fill_n(x, nx, 0.0);
    std::fill_n(y, nx, 0.0);
    std::vector<double> pulls(8 * nx);  // x and y of four images
    const auto fill = [&](std::size_t image, const Kept& bond, bool keeps) {
      double* of = &pulls[2 * image * nx];
      pull_row(u, j, bond, keeps, of, of + nx);
    };
    const auto at = [&](std::size_t part) { return &pulls[part * nx]; };
    for (const std::size_t k : images_) {
      fill(0, kept_[k], true);
      fill(1, kept_[k], false);
      if (kept_[k].a == 0 || kept_[k].b == 0) {
        for (std::size_t i = 0; i < nx; ++i) {
          x[i] += at(0)[i] + at(2)[i];
          y[i] += at(1)[i] + at(3)[i];
        }
        continue;
      }
      fill(2, kept_[k + 1], true);
      fill(3, kept_[k + 1], false);
      for (std::size_t i = 0; i < nx; ++i) {
        x[i] += (at(0)[i] + at(4)[i]) + (at(2)[i] + at(6)[i]);
        y[i] += (at(1)[i] + at(5)[i]) + (at(3)[i] + at(7)[i]);
      }
    }
  });
}

float* LinearisedBonds::slice(int j, std::size_t bond, int component) {
  return const_cast<float*>(std::as_const(*this).slice(j, bond, component));
}

const float* LinearisedBonds::slice(int j, std::size_t bond, int component) const {
  if (j < 0) return zeros_.data();
  const auto row = static_cast<std::size_t>(j) * kept_.size();
  return tangent_.data() + (3 * (row + bond) + static_cast<std::size_t>(component)) *
                               static_cast<std::size_t>(layout().stride());
}

void LinearisedBonds::linearise(const NodeVectors& u, Tangent tangent) {
  const auto stride = static_cast<std::size_t>(layout().stride());
  const Grid& grid = lattice_->grid;
  zeros_.assign(stride + NodeLayout::group, 0.0F);
  tangent_.assign(3 * stride * kept_.size() * static_cast<std::size_t>(grid.ny) + NodeLayout::group,
                  0.0F);
  own_.resize(grid.nodes());
  for_rows(threads_, grid.ny, [&](int j) { linearise_row(u, tangent, j); });
  for_rows(threads_, grid.ny, [&](int j) { sum_own_row(j); });
}

void LinearisedBonds::forget(const std::vector<BrokenBond>& broken_bonds) {
  if (tangent_.empty()) return;
  std::vector<char> touched(static_cast<std::size_t>(lattice_->grid.ny));
  for (const BrokenBond& broken : broken_bonds) {
    const int bit = 32 * broken.word + std::countr_zero(broken.bit);
    const auto j = static_cast<int>(broken.at / layout().stride());
    const std::ptrdiff_t column = broken.at - j * layout().stride();
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      if (kept_[k].bit != bit) continue;
      for (int component = 0; component < 3; ++component) slice(j, k, component)[column] = 0.0F;
      for (const int row : {j, j + kept_[k].b}) touched[static_cast<std::size_t>(row)] = 1;
    }
  }
  for_rows(threads_, lattice_->grid.ny, [&](int j) {
    if (touched[static_cast<std::size_t>(j)] != 0) sum_own_row(j);
  });
}

void LinearisedBonds::linearise_row(const NodeVectors& u, Tangent tangent, int j) {
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    float *xx = slice(j, k, 0), *xy = slice(j, k, 1), *yy = slice(j, k, 2);
    for (int i = 0; i < lattice_->grid.nx; ++i) {
      if (!holds(i, j, kept_[k])) continue;
      const Stiffness stiffness = stiffness_of(u, i, j, kept_[k], tangent);
      const std::ptrdiff_t column = layout().at(i, 0);
      xx[column] = static_cast<float>(stiffness.xx);
      xy[column] = static_cast<float>(stiffness.xy);
      yy[column] = static_cast<float>(stiffness.yy);
    }
  }
}

void LinearisedBonds::sum_own_row(int j) {
  const auto at = [&](std::size_t k, int i, bool keeps) -> Stiffness {
    const Kept& bond = kept_[k];
    const int row = keeps ? j : j - bond.b;
    const std::ptrdiff_t column = layout().at(keeps ? i : i - bond.a, 0);
    return {slice(row, k, 0)[column], slice(row, k, 1)[column], slice(row, k, 2)[column]};
  };
  const auto plus = [](const Stiffness& p, const Stiffness& q) -> Stiffness {
    return {p.xx + q.xx, p.xy + q.xy, p.yy + q.yy};
  };
  for (int i = 0; i < lattice_->grid.nx; ++i) {
    Stiffness sum;
    for (const std::size_t k : images_)
      if (kept_[k].a == 0 || kept_[k].b == 0)
        sum = plus(sum, plus(at(k, i, true), at(k, i, false)));
      else
        sum = plus(sum, plus(plus(at(k, i, true), at(k + 1, i, true)),
                             plus(at(k, i, false), at(k + 1, i, false))));
    own_[lattice_->grid.index(i, j)] = sum;
  }
}

Stiffness LinearisedBonds::own_stiffness(int i, int j) const {
  return own_[lattice_->grid.index(i, j)];
}

namespace {

// One image of an offset for the nodes of a row: stiffness, and the vectors at the far ends.
struct Arm {
  const float *xx, *xy, *yy;
  const double *x, *y;
};

Vec2 pull(const Arm& arm, std::ptrdiff_t i, double x, double y) {
  const double hx = arm.x[i] - x, hy = arm.y[i] - y;
  const double xx = arm.xx[i], xy = arm.xy[i], yy = arm.yy[i];
  return {xx * hx + xy * hy, xy * hx + yy * hy};
}

}  // namespace

// A deliberately plain loop over columns, without branches: ghosts and broken bonds have stiffness
// 0. Rows beyond the plate are replaced by the row itself, with a stiffness of 0.
void LinearisedBonds::apply_row(const NodeVectors& p, NodeVectors& result, int j) const {
  const std::ptrdiff_t first = layout().at(0, j), column = layout().at(0, 0);
  const int nx = lattice_->grid.nx, ny = lattice_->grid.ny;
  double *out_x = &result.x[static_cast<std::size_t>(first)],
         *out_y = &result.y[static_cast<std::size_t>(first)];
  const double *x = p.x.data() + first, *y = p.y.data() + first;
  const auto arm = [&](std::size_t k, bool keeps) -> Arm {
    const Kept& bond = kept_[k];
    const int side = keeps ? 1 : -1, row = j + side * bond.b;
    const bool inside = row >= 0 && row < ny;
    const std::ptrdiff_t shift = keeps ? column : column - bond.a;
    const int up = side * bond.b, across = side * bond.a;
    const std::ptrdiff_t to = across + (inside ? up * layout().stride() : 0);
    const int keeper = keeps ? (inside ? j : -1) : (inside ? row : -1);
    const auto of = [&](int component) {
      return keeper < 0 ? zeros_.data() + shift : slice(keeper, k, component) + shift;
    };
    return {of(0), of(1), of(2), x + to, y + to};
  };
  std::fill_n(out_x, nx, 0.0);
  std::fill_n(out_y, nx, 0.0);
  for (const std::size_t k : images_) {
    const Arm up = arm(k, true), down = arm(k, false);
    if (kept_[k].a == 0 || kept_[k].b == 0) {
      for (int i = 0; i < nx; ++i) {
        const Vec2 f1 = pull(up, i, x[i], y[i]), f2 = pull(down, i, x[i], y[i]);
        out_x[i] += f1.x() + f2.x();
        out_y[i] += f1.y() + f2.y();
      }
      continue;
    }
    const Arm up_left = arm(k + 1, true), down_right = arm(k + 1, false);
    for (int i = 0; i < nx; ++i) {
      const Vec2 f1 = pull(up, i, x[i], y[i]), f2 = pull(up_left, i, x[i], y[i]);
      const Vec2 f3 = pull(down, i, x[i], y[i]), f4 = pull(down_right, i, x[i], y[i]);
      out_x[i] += (f1.x() + f2.x()) + (f3.x() + f4.x());
      out_y[i] += (f1.y() + f2.y()) + (f3.y() + f4.y());
    }
  }
}

}  // namespace hackle
