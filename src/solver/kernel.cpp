// SPDX-License-Identifier: MIT
#include "solver/kernel.hpp"

#include "solver/kernel_f64.hpp"

namespace hackle {

bool is_supported(InstructionSet set) {
  switch (set) {
    case InstructionSet::baseline:
      return true;
#ifdef __x86_64__
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2") != 0;
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
             __builtin_cpu_supports("avx512vl") != 0;
#else
    default:
      return false;
#endif
  }
  return false;
}

InstructionSet best_instruction_set() {
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2})
    if (is_supported(set)) return set;
  return InstructionSet::baseline;
}

ForceKernel find_kernel(const KernelChoice& choice) {
  switch (choice.instruction_set) {
#ifdef __x86_64__
    case InstructionSet::avx2:
      return avx2::kernel_f64(choice.guarded);
    case InstructionSet::avx512:
      return avx512::kernel_f64(choice.guarded);
#endif
    default:
      return baseline::kernel_f64(choice.guarded);
  }
}

}  // namespace hackle
