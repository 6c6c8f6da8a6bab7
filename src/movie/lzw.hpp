// SPDX-License-Identifier: MIT
// The compression of GIF: LZW with codes of up to twelve bits.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace hackle {

// Returns the code stream for at least one byte, as in the GIF89a specification (appendix F) for
// pixels of eight bits, not yet divided into blocks.
std::vector<std::uint8_t> lzw(std::span<const std::uint8_t> bytes);

}  // namespace hackle
