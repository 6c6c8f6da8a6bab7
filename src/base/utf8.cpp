// SPDX-License-Identifier: MIT
#include "base/utf8.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace hackle {

bool is_utf8(std::string_view text) {
  // The smallest code point per length; a shorter sequence cannot encode it.
  constexpr std::array<std::uint32_t, 5> min{0, 0, 0x80, 0x800, 0x10000};
  for (std::size_t at = 0; at < text.size();) {
    const auto first = static_cast<unsigned char>(text[at]);
    const auto length = static_cast<std::size_t>(std::countl_one(first));
    if (length == 1 || length > 4 || at + std::max<std::size_t>(length, 1) > text.size())
      return false;
    std::uint32_t code = first & (0xFFU >> (length + 1));
    for (std::size_t k = 1; k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[at + k]);
      if ((next & 0xC0U) != 0x80U) return false;
      code = code << 6U | (next & 0x3FU);
    }
    const bool is_surrogate = code >= 0xD800 && code < 0xE000;
    if (length > 0 && (code < min.at(length) || code > 0x10FFFF || is_surrogate)) return false;
    at += std::max<std::size_t>(length, 1);
  }
  return true;
}

}  // namespace hackle
