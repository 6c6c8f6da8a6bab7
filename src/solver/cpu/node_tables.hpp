// SPDX-License-Identifier: MIT
#pragma once

#include "lattice/lattice.hpp"
#include "solver/cpu/kernel.hpp"
#include "solver/values.hpp"

namespace hackle {

// What a kernel reads of every node and does not change: see KernelData. Values are per place.
template <class Real>
struct NodeTables {
  NodeTables(const Lattice& lattice, const KernelFeatures& features);

  std::size_t bytes() const;

  Real alpha{};                                  // of the plate's own material
  Real min_threshold{};                          // at its critical stretch
  Values<Real> s00;                              // empty unless varied
  Values<Real> threshold;                        // of an undeformed plate; empty unless varied
  Values<Real> half_stiffness, inverse_inertia;  // empty unless mixed
  Values<Real> alphas;                           // empty unless mixed with a history

 private:
  void set_thresholds(const Lattice& lattice, bool mixed);
  void set_materials(const Lattice& lattice, bool history);
};

extern template struct NodeTables<float>;
extern template struct NodeTables<double>;

}  // namespace hackle
