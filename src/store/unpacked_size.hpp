// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hackle {

// Returns whether a deflated piece unpacks to at most `most` bytes; bytes behind its end are
// ignored. The unpacked bytes are not stored: HDF5 itself has no such limit.
bool unpacks_within(std::span<const std::uint8_t> piece, std::size_t max);

}  // namespace hackle
