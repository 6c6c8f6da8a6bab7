// SPDX-License-Identifier: MIT
// The inner loop's interface: a kernel gives rows of nodes their acceleration and breaks their
// bonds. Everything it needs is prepared in tables; which kernel runs is chosen once, by precision,
// options of the scene and instruction set. All kernels of one precision give the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace hackle {

// The mirror images of one offset (a, b), in lattice units (kernel.md 0). With h the relative
// displacement, E = hx (hx + 2a) + hy (hy + 2b) = L^2 e.
struct BondClass {
  double a = 0.0;
  double b = 0.0;
  double inverse_L2 = 0.0;     // 1/L^2, L^2 = a^2 + b^2
  double pull = 0.0;           // K = c w dx dt^2/(rho L): acceleration is K g(e) (a + hx, b + hy)
  double most = 0.0;           // the bond breaks when E is above: L^2 ((1 + s0)^2 - 1)
  std::ptrdiff_t columns = 0;  // a, as an offset in memory
  std::ptrdiff_t rows = 0;     // b * stride
  int first_bit = 0;           // within its word
  int word = 0;
  int images = 0;  // 4, or 2 on an axis
};

// What a kernel reads and writes. Pointers to u address node (0, 0) of arrays with a rim; the
// others have nx values a row.
struct KernelData {
  int nx = 0;
  std::ptrdiff_t stride = 0;  // of u
  std::ptrdiff_t plane = 0;   // words of bond bits between two planes
  const BondClass* classes = nullptr;
  int class_count = 0;
  const double* ux = nullptr;
  const double* uy = nullptr;
  double* ax = nullptr;
  double* ay = nullptr;
  std::uint64_t* bonds = nullptr;
  const std::uint64_t* unbreakable = nullptr;  // read by guarded kernels only
};

// Computes rows row_begin <= j < row_end. Rows may be given to any number of threads: a row reads
// u of its neighbours and writes only what is its own.
using ForceKernel = void (*)(const KernelData& data, int row_begin, int row_end);

enum class InstructionSet { baseline, avx2, avx512 };
inline constexpr std::array<std::string_view, 3> instruction_set_names{"baseline", "avx2",
                                                                       "avx512"};

// Whether this machine has it.
bool is_supported(InstructionSet set);
InstructionSet best_instruction_set();

struct KernelChoice {
  InstructionSet instruction_set = InstructionSet::baseline;
  bool guarded = false;  // the scene has no-fail zones
};
ForceKernel find_kernel(const KernelChoice& choice);

}  // namespace hackle
