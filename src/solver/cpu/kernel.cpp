// SPDX-License-Identifier: MIT
#include "solver/cpu/kernel.hpp"

#include "solver/cpu/kernel_advance.hpp"

namespace hackle {

void note_broken_bond(std::vector<BrokenBond>& broken_bonds, const BrokenBond& broken) {
  broken_bonds.push_back(broken);
}

template <class Real>
Kernel<Real> find_kernel(InstructionSet set, Arithmetic arithmetic, KernelFeatures features) {
  const bool fused = arithmetic == Arithmetic::fused;
  switch (set) {
#ifdef __x86_64__
    case InstructionSet::avx2:
      return fused ? avx2_fused::kernel<Real>(features) : avx2::kernel<Real>(features);
#endif
#ifdef HACKLE_AVX512
    case InstructionSet::avx512:
      return fused ? avx512_fused::kernel<Real>(features) : avx512::kernel<Real>(features);
#endif
#ifdef __aarch64__
    case InstructionSet::baseline:
      if (fused) return baseline_fused::kernel<Real>(features);
      [[fallthrough]];
#endif
    default:
      return baseline::kernel<Real>(features);
  }
}

template Kernel<float> find_kernel(InstructionSet set, Arithmetic arithmetic,
                                   KernelFeatures features);
template Kernel<double> find_kernel(InstructionSet set, Arithmetic arithmetic,
                                    KernelFeatures features);

}  // namespace hackle
