// SPDX-License-Identifier: MIT
#include "solver/state.hpp"

#include <algorithm>
#include <array>
#include <span>

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

// The order of discs has no meaning.
std::vector<std::array<double, 4>> sorted(const std::vector<Disc>& discs) {
  std::vector<std::array<double, 4>> list;
  list.reserve(discs.size());
  for (const auto& [centre, velocity] : discs)
    list.push_back({centre.x(), centre.y(), velocity.x(), velocity.y()});
  std::ranges::sort(list);
  return list;
}

// Adds members to a hash.
struct Hasher {
  const NodeLayout& layout;
  Hash& hash;

  template <class Member>
  void operator()(const char*, const Member& member, bool matters) const {
    if (matters) add(member);
  }

  template <class Real>
  void add(const Values<Real>& values) const {
    for (int j = 0; j < layout.ny && !values.empty(); ++j)
      hash.add(std::span(values).subspan(static_cast<std::size_t>(layout.at(0, j)),
                                         static_cast<std::size_t>(layout.nx)));
  }
  void add(const BondBits& bonds) const { hash.add(std::span(bonds.words())); }
  void add(const std::int64_t& number) const { hash.add(std::span(&number, 1)); }
  void add(const double& number) const { hash.add(std::span(&number, 1)); }
  void add(const Vec2& vector) const { hash.add(std::span(vector.data(), 2)); }
  void add(const Clock& clock) const {
    add(clock.moment);
    add(clock.since);
  }
  void add(const std::vector<Disc>& discs) const {
    for (const std::array<double, 4>& disc : sorted(discs)) hash.add(std::span<const double>(disc));
  }
};

// What a member holds that grows with the plate.
template <class Real>
std::size_t bytes_of_member(const Values<Real>& values) {
  return bytes_of(values);
}
std::size_t bytes_of_member(const BondBits& bonds) {
  return bytes_of(bonds.words());
}
template <class Other>
std::size_t bytes_of_member(const Other&) {
  return 0;
}

}  // namespace

State::State(const Lattice& lattice, Precision precision)
    : layout(lattice.grid.layout()), bonds(lattice.bonds) {
  if (precision == Precision::f32)
    motion = at_rest<float>(lattice);
  else
    motion = at_rest<double>(lattice);
}

bool fits(const State& state, const Lattice& lattice) {
  const std::size_t size = lattice.grid.layout().size();
  const auto fitting = [size](const auto& motion) {
    bool good = motion.threshold.empty() || motion.threshold.size() == size;
    for (const auto* values : {&motion.ux, &motion.uy, &motion.vx, &motion.vy})
      good = good && values->size() == size;
    return good;
  };
  const std::vector<std::uint32_t>&now = state.bonds.words(), &initial = lattice.bonds.words();
  if (state.layout != lattice.grid.layout() || !std::visit(fitting, state.motion) ||
      now.size() != initial.size())
    return false;
  for (std::size_t at = 0; at < now.size(); ++at)
    if ((now[at] & ~initial[at]) != 0) return false;
  return true;
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
  for_each_member(*this, Hasher{layout, hash});
  return hash.hex();
}

std::size_t State::bytes() const {
  std::size_t sum = 0;
  for_each_member(*this,
                  [&](const char*, const auto& member, bool) { sum += bytes_of_member(member); });
  return sum;
}

State State::in_f64() const {
  State wide = *this;
  if (const auto* narrow = std::get_if<Motion<float>>(&motion)) {
    auto& motion_f64 = wide.motion.emplace<Motion<double>>();
    for_each_array([](const char*, const Values<float>& from,
                      Values<double>& to) { to.assign(from.begin(), from.end()); },
                   *narrow, motion_f64);
  }
  return wide;
}

}  // namespace hackle
