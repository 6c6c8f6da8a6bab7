// SPDX-License-Identifier: MIT
#include "solver/state.hpp"

#include <algorithm>
#include <array>

#include "base/hash.hpp"

namespace hackle {
namespace {

template <class Real>
Motion<Real> at_rest(const Lattice& lattice) {
  const std::size_t size = lattice.grid.layout().size();
  Motion<Real> motion;
  for (Values<Real>* values : {&motion.ux, &motion.uy, &motion.vx, &motion.vy})
    values->resize(size);
  return motion;
}

template <class Real>
void set(Values<Real>& x, Values<Real>& y, std::size_t at, const Vec2& value) {
  x[at] = static_cast<Real>(value.x());
  y[at] = static_cast<Real>(value.y());
}

// The order in which discs were said means nothing.
std::vector<std::array<double, 4>> sorted(const std::vector<Disc>& discs) {
  std::vector<std::array<double, 4>> list;
  list.reserve(discs.size());
  for (const auto& [centre, velocity] : discs)
    list.push_back({centre.x(), centre.y(), velocity.x(), velocity.y()});
  std::ranges::sort(list);
  return list;
}

}  // namespace

State::State(const Lattice& lattice, Precision precision)
    : layout(lattice.grid.layout()), bonds(lattice.bonds) {
  if (precision == Precision::f32)
    motion = at_rest<float>(lattice);
  else
    motion = at_rest<double>(lattice);
}

Vec2 State::u(int i, int j) const {
  const auto at = static_cast<std::size_t>(layout.at(i, j));
  return std::visit([&](const auto& m) { return Vec2(m.ux[at], m.uy[at]); }, motion);
}

Vec2 State::v(int i, int j) const {
  const auto at = static_cast<std::size_t>(layout.at(i, j));
  return std::visit([&](const auto& m) { return Vec2(m.vx[at], m.vy[at]); }, motion);
}

void State::set_u(int i, int j, const Vec2& u) {
  const auto at = static_cast<std::size_t>(layout.at(i, j));
  std::visit([&](auto& m) { set(m.ux, m.uy, at, u); }, motion);
}

void State::set_v(int i, int j, const Vec2& v) {
  const auto at = static_cast<std::size_t>(layout.at(i, j));
  std::visit([&](auto& m) { set(m.vx, m.vy, at, v); }, motion);
}

std::string State::hash() const {
  Hash hash;
  std::visit(
      [&](const auto& m) {
        for (const auto* values : {&m.ux, &m.uy, &m.vx, &m.vy, &m.threshold})
          for (int j = 0; j < layout.ny && !values->empty(); ++j)
            hash.add(std::span(*values).subspan(static_cast<std::size_t>(layout.at(0, j)),
                                                static_cast<std::size_t>(layout.nx)));
      },
      motion);
  hash.add(std::span(bonds.words()));
  hash.add(std::span(&step, 1));
  hash.add(std::span(&external_work, 1));
  if (start != 0 && is_start()) hash.add(std::span(&start, 1));  // it changes what comes
  if (clock != Clock{}) {
    hash.add(std::span(&clock.moment, 1));
    hash.add(std::span(&clock.since, 1));
  }
  for (const double* energy : {&damped, &released, &contact_lost})
    if (*energy != 0.0) hash.add(std::span(energy, 1));
  hash.add(std::span(origin.data(), 2));
  for (const std::array<double, 4>& disc : sorted(discs)) hash.add(std::span<const double>(disc));
  return hash.hex();
}

}  // namespace hackle
