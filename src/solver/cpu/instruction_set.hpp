// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace hackle {

enum class InstructionSet { baseline, avx2, avx512 };
inline constexpr std::array<std::string_view, 3> instruction_set_names{"baseline", "avx2",
                                                                       "avx512"};

// Whether this machine supports it.
bool is_supported(InstructionSet set);
InstructionSet best_instruction_set();

// Whether multiplications and additions of a kernel are rounded one by one, the same on every
// machine, or fused into one rounding, which is faster, somewhat more exact, and the same on every
// machine that can.
enum class Arithmetic { plain, fused };
// Whether the instruction set has fused arithmetic.
bool can_fuse(InstructionSet set);

}  // namespace hackle
