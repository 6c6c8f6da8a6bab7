// SPDX-License-Identifier: MIT
#include "solver/kernel.hpp"

#include "solver/kernel_advance.hpp"

namespace hackle {

void note_broken_bond(std::vector<BrokenBond>& broken_bonds, const BrokenBond& broken) {
  broken_bonds.push_back(broken);
}

bool is_supported(InstructionSet set) {
  switch (set) {
    case InstructionSet::baseline:
      return true;
#ifdef __x86_64__
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2") != 0;
#endif
#ifdef HACKLE_AVX512
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
             __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512bw") != 0;
#endif
    default:
      return false;
  }
}

InstructionSet best_instruction_set() {
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2})
    if (is_supported(set)) return set;
  return InstructionSet::baseline;
}

bool can_fuse(InstructionSet set) {
#ifdef __x86_64__
  return set != InstructionSet::baseline && __builtin_cpu_supports("fma") != 0;
#else
  return set == InstructionSet::baseline;
#endif
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
