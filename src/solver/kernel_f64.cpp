// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, into the namespace HACKLE_INSTRUCTION_SET. It calls no
// function of the standard library: an inline function compiled here for a wide machine could be
// the copy that the linker keeps for everybody.
//
// Bits do not depend on the instruction set: every node is computed by the same IEEE operations in
// the same order, one lane a node, and contraction is off. Mirror images are summed as
// (f1 + f2) + (f3 + f4), which exchanges terms of a commutative sum under any mirror, so a
// symmetric scene stays symmetric to the last bit (kernel.md 2).
#include "solver/kernel_f64.hpp"

namespace hackle::HACKLE_INSTRUCTION_SET {
namespace {

struct Force {
  double x, y;
};

// The force of one bond on its node, 0 when it is broken; clears its bit in `bonds` when it breaks.
// `a`, `b` carry the signs of the image.
//
// g(e) = 1 - 1/sqrt(1+e) = e / ((1+e) + sqrt(1+e)), free of cancellation; (1+s)^2 = 1+e. Selections
// are written with masks of all ones or zeros, which every instruction set can vectorise.
template <bool guarded>
inline Force bond_force(const BondClass& images, double a, double b, double hx, double hy,
                        std::uint64_t bit, std::uint64_t safe, std::uint64_t& bonds) {
  const double E = hx * (hx + 2.0 * a) + hy * (hy + 2.0 * b);
  const std::uint64_t over = E > images.most ? bit : 0;
  bonds &= guarded ? ~over | safe : ~over;
  const double e = E * images.inverse_L2;
  // Squared length ratio; two nodes that meet exactly must not divide by zero.
  const double squared = 1.0 + e > 1e-12 ? 1.0 + e : 1e-12;
  const double g = e / (squared + __builtin_sqrt(squared));
  const double held = (bonds & bit) != 0 ? images.pull : 0.0;
  return {held * g * (a + hx), held * g * (b + hy)};
}

// Adds the bonds of the images of one offset, four or (on an axis) two, to a row of nodes. Pointers
// to its first node; `restrict` on parameters (not on locals or members) is what lets the loop be
// vectorised.
template <bool guarded, int images>
void add_images(const BondClass k, int nx, const double* __restrict ux, const double* __restrict uy,
                double* __restrict ax, double* __restrict ay, std::uint64_t* __restrict bonds,
                const std::uint64_t* __restrict unbreakable) {
  const std::ptrdiff_t pp = k.rows + k.columns, pm = k.columns - k.rows;
  const std::uint64_t bit = std::uint64_t{1} << k.first_bit;
  for (int i = 0; i < nx; ++i) {
    const double x = ux[i], y = uy[i];
    const std::uint64_t safe = guarded ? unbreakable[i] : 0;
    std::uint64_t held = bonds[i];
    const auto force = [&](double a, double b, std::ptrdiff_t to, int image) {
      return bond_force<guarded>(k, a, b, ux[i + to] - x, uy[i + to] - y, bit << image, safe, held);
    };
    const Force first = force(k.a, k.b, pp, 0);
    if constexpr (images == 4) {
      const Force f2 = force(k.a, -k.b, pm, 1);
      const Force f3 = force(-k.a, k.b, -pm, 2);
      const Force f4 = force(-k.a, -k.b, -pp, 3);
      ax[i] += (first.x + f2.x) + (f3.x + f4.x);
      ay[i] += (first.y + f2.y) + (f3.y + f4.y);
    } else {
      const Force opposite = force(-k.a, -k.b, -pp, 1);
      ax[i] += first.x + opposite.x;
      ay[i] += first.y + opposite.y;
    }
    bonds[i] = held;
  }
}

template <bool guarded>
void force_rows(const KernelData& data, int row_begin, int row_end) {
  for (int j = row_begin; j < row_end; ++j) {
    const std::ptrdiff_t in_u = j * data.stride, in_a = static_cast<std::ptrdiff_t>(j) * data.nx;
    double* ax = data.ax + in_a;
    double* ay = data.ay + in_a;
    for (int i = 0; i < data.nx; ++i) ax[i] = ay[i] = 0.0;
    for (int c = 0; c < data.class_count; ++c) {
      const BondClass& k = data.classes[c];
      const std::ptrdiff_t in_bits = k.word * data.plane + in_a;
      const auto add = k.images == 4 ? add_images<guarded, 4> : add_images<guarded, 2>;
      add(k, data.nx, data.ux + in_u, data.uy + in_u, ax, ay, data.bonds + in_bits,
          guarded ? data.unbreakable + in_bits : nullptr);
    }
  }
}

}  // namespace

ForceKernel kernel_f64(bool guarded) {
  return guarded ? force_rows<true> : force_rows<false>;
}

}  // namespace hackle::HACKLE_INSTRUCTION_SET
