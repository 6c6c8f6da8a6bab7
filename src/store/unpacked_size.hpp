// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hackle {

// Whether a deflated piece, which what is behind its end does not belong to, unpacks to at most so
// many bytes. Takes no memory for them: HDF5 itself asks no limit.
bool unpacks_within(std::span<const std::uint8_t> piece, std::size_t most);

}  // namespace hackle
