// SPDX-License-Identifier: MIT
// The inner loop's interface: a kernel advances some rows of the plate by one time step. Everything
// it needs is prepared in tables; the kernel is chosen once, by precision, options of the scene and
// instruction set. All kernels of one precision give the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lattice/node_layout.hpp"
#include "solver/broken_bond.hpp"
#include "solver/cpu/instruction_set.hpp"
#include "solver/cpu/tiles.hpp"

namespace hackle {

template <class Real>
struct Scratch;

// g(e)/e = 1/((1+e) + sqrt(1+e)) as a polynomial of e, interpolated at the Chebyshev nodes of |e|
// <= series_range: its relative error is at most 6.6e-8 (f32) and 9.4e-17 (f64) there, about half a
// unit in the last place (src/solver/README.md 2.3).
template <class Real>
inline constexpr int series_terms = sizeof(Real) == 4 ? 3 : 6;
template <class Real>
inline constexpr Real series_range = sizeof(Real) == 4 ? Real{0.0078125} : Real{0.00390625};

// The mirror images of one offset, in lattice units (src/solver/README.md 2.2). With xi = (a, b), L
// its length and h the relative displacement, E = hx (hx + 2a) + hy (hy + 2b) = L^2 e, and the
// acceleration is K g(e) (a + hx, b + hy) with K = c w dx dt^2/(rho L).
template <class Real>
struct BondClass {
  Real a{};
  Real b{};
  std::array<Real, series_terms<Real>> series{};  // K g(e) = E (series[0] + E (series[1] + ...))
  Real range{};                                   // |E| up to which the series is exact
  Real most{};  // the bond breaks if E exceeds it: L^2 ((1 + s0)^2 - 1)
  Real sure{};  // |E| up to which the bond is intact and the series is exact
  Real L2{};
  Real inverse_L2{};  // 1/L^2
  Real pull{};        // K
  int columns = 0;
  int rows = 0;
  int images = 0;         // kept by a node: 2, or 1 on an axis
  int word = 0;           // of its bits
  std::uint32_t bit = 0;  // of the first image, as a mask; the second is twice that
};

// The linearised bonds, by columns a and rows b of their offset: K/L^2 times xi xi^T.
template <class Real>
struct LinearWeight {
  Real xx{};
  Real xy{};
  Real yy{};
};
template <class Real>
struct LinearStencil {
  int reach = 0;
  bool round = false;  // the family of an integer m: every offset with a^2 + b^2 <= reach^2
  Real own_x{};        // sum of xx over all bonds of a node, and of yy
  Real own_y{};
  int max_rows[NodeLayout::group + 1] = {};  // the largest b for every a
  LinearWeight<Real> weights[NodeLayout::group + 1][NodeLayout::group + 1] = {};
};

// |e| <= 2 (direct A + shear (B + C)) + squares (2 A^2 + B^2 + C^2) for every bond between nodes
// whose neighbours differ by at most A (|d_x u_x|, |d_y u_y|), B (|d_y u_x|) and C (|d_x u_y|), by
// Cauchy (src/solver/README.md 4.5). 1, 1/2 and 1, unless bonds end beside their neighbour
// (Quadrature::centroid).
template <class Real>
struct BoundFactors {
  Real direct{1};
  Real shear{0.5};
  Real squares{1};
};

// An acceleration of one node, in lattice units.
template <class Real>
struct NodeLoad {
  int i = 0;
  Real x{};
  Real y{};
};

// A prescribed node: it moves by x, y in this step for any forces, along one axis or both.
template <class Real>
struct PrescribedMotion {
  int i = 0;
  bool along_x = true;
  bool along_y = true;
  Real x{};
  Real y{};
  // Written by the kernel: the work of the support up to the beginning of the step, for a node of
  // mass 1. It is the change of momentum not caused by bonds and loads, times the mean of the
  // velocities before and after; at the start, without a previous step, half of that.
  Real work{};
};

// The input and output of a kernel. Arrays begin at place 0 of the layout.
template <class Real>
struct KernelData {
  NodeLayout layout;
  int reach = 0;
  const BondClass<Real>* classes = nullptr;  // rows from far to near, those on the row itself last
  int class_count = 0;
  int first_on_row = 0;  // class

  const Real* ux = nullptr;
  const Real* uy = nullptr;
  Real* next_ux = nullptr;
  Real* next_uy = nullptr;
  Real* vx = nullptr;
  Real* vy = nullptr;
  Real kick =
      1;  // factor of an acceleration in v, in steps: 1, or 1/2 at the start; less with damping
  bool starts = false;  // u and v belong to the same time

  const std::uint32_t* bonds = nullptr;
  // Read by guarded kernels only; mixed and heated ones accept nullptr without zones.
  const std::uint32_t* unbreakable = nullptr;
  std::size_t plane = 0;  // words from one plane of bits to the next
  bool late = false;      // see Breaking

  // Read by varied kernels: e above which the bonds of a node break. A history moves it.
  const Real* threshold = nullptr;
  Real* next_threshold = nullptr;
  const Real* s00 = nullptr;  // critical stretch of a node without history
  Real alpha{};

  // Read by mixed kernels. K belongs to the plate's own material: a bond has K (half_i + half_j),
  // half = c/2 over the c of that; a node has its density, own_rho/rho. A history follows the alpha
  // of the node.
  const Real* half_stiffness = nullptr;
  const Real* inverse_inertia = nullptr;
  const Real* alphas = nullptr;

  // Read by heated kernels: the thermal strain th of a node, and the largest |th| of every tile. A
  // bond has the e of the strain that pulls, e - (th_i + th_j), first order in th.
  const Real* heat = nullptr;
  const Real* tile_heat = nullptr;

  const NodeLoad<Real>* loads = nullptr;
  const std::size_t* loads_of_row = nullptr;  // row j has loads[loads_of_row[j]] and following
  PrescribedMotion<Real>* prescribed = nullptr;
  const std::size_t* prescribed_of_row = nullptr;  // null without prescribed nodes

  TileGrid tiles;
  const TileRange<Real>* range = nullptr;  // of u
  TileRange<Real>* next_range = nullptr;   // of next_u
  const std::uint8_t* intact = nullptr;    // per tile: every bond kept in it is intact
  const std::uint8_t* loaded = nullptr;    // per tile: a load acts in it
  BoundFactors<Real> bound;
  Real min_threshold{};                    // if thresholds do not vary
  const std::uint8_t* complete = nullptr;  // per tile: every bond of its nodes is intact
  Real linear_range{};                     // e below which forces may be linearised; 0: never
  const LinearStencil<Real>* stencil = nullptr;

  // If set, the acceleration is written here and nothing else changes.
  Real* ax = nullptr;
  Real* ay = nullptr;
};

// Rows row_begin <= j < row_end, which begin and end on borders of tiles.
struct Rows {
  int begin = 0;
  int end = 0;
};

template <class Real>
struct Kernel {
  // Advances the rows by one step: reads u of nodes up to `reach` rows away, writes only data of
  // its rows. Overstretched bonds are appended to the scratch's list, and the caller breaks them
  // when all rows are done.
  void (*advance)(const KernelData<Real>& data, Scratch<Real>& scratch, Rows rows) = nullptr;
  // Fills next_range of the rows from next_u, without differences across the border of the rows.
  void (*survey)(const KernelData<Real>& data, Rows rows) = nullptr;
  // Adds the differences between the rows j - 1 and j, which belong to two tiles.
  void (*join)(const KernelData<Real>& data, int j) = nullptr;
};

// What a scene needs of a kernel; the rest is compiled out. Mixed and heated imply guarded and
// varied: those tests cost only where a bond may break, whereas mixed and heated cost in every
// bond. These two are separate flags, as most heated plates have one material and most mixed ones
// are not heated. The implication makes six more kernels instead of eighteen.
struct KernelFeatures {
  bool guarded = false;  // no-fail zones
  bool varied = false;   // the critical stretch varies from node to node
  bool history = false;  // and follows the smallest stretch; implies varied
  bool mixed = false;    // stiffness or density vary from node to node; implies the first two
  bool heated = false;   // thermal strain; implies the first two

  friend bool operator==(const KernelFeatures&, const KernelFeatures&) = default;
};

template <class Real>
Kernel<Real> find_kernel(InstructionSet set, Arithmetic arithmetic, KernelFeatures features);

}  // namespace hackle
