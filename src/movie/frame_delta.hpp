// SPDX-License-Identifier: MIT
// What changes from a picture to the next, in few bytes and exactly.
#pragma once

#include <cstdint>
#include <span>

#include "base/image.hpp"
#include "movie/byte_file.hpp"

namespace hackle {

// Most rows of a running crack are those of the picture before, and where a cell of the plate is
// several pixels high, rows repeat the one above; in the others, pixels are skipped, repeated,
// taken from 64 recent ones, or differ little from their left neighbour. Returns the bytes that
// turn `before` into `now`, of the same size. Sets `before` to `now`.
Bytes advance_by_delta(Image& before, const Image& now);

// Turns the picture into the next. Returns false, with the picture in any state, if the bytes are
// no delta of a picture of that size.
bool apply_delta(std::span<const std::uint8_t> delta, Image& picture);

}  // namespace hackle
