// SPDX-License-Identifier: MIT
// The compression of GIF: LZW with codes of up to twelve bits.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace hackle {

// The code stream of at least one byte, as the GIF89a specification (appendix F) has it for pixels
// of eight bits, not yet cut into blocks.
std::vector<std::uint8_t> lzw(std::span<const std::uint8_t> bytes);

}  // namespace hackle
