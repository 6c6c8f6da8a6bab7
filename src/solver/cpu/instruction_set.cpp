// SPDX-License-Identifier: MIT
#include "solver/cpu/instruction_set.hpp"

namespace hackle {

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

}  // namespace hackle
