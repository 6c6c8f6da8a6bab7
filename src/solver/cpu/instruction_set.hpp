// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace hackle {

enum class InstructionSet { baseline, avx2, avx512 };
inline constexpr std::array<std::string_view, 3> instruction_set_names{"baseline", "avx2",
                                                                       "avx512"};

// Returns whether this machine supports it.
bool is_supported(InstructionSet set);
InstructionSet best_instruction_set();

// Plain: each multiplication and addition of a kernel is rounded, the same on every machine. Fused:
// both are rounded once, which is faster, slightly more exact, and the same on every machine that
// supports it.
enum class Arithmetic { plain, fused };
// Returns whether the instruction set has fused arithmetic.
bool can_fuse(InstructionSet set);

}  // namespace hackle
