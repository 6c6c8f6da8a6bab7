// SPDX-License-Identifier: MIT
#include "store/unpacked_size.hpp"

#include <array>

#include <zlib.h>

namespace hackle {

bool unpacks_within(std::span<const std::uint8_t> piece, std::size_t max) {
  z_stream stream{};
  stream.next_in = const_cast<Bytef*>(piece.data());  // zlib only reads them
  stream.avail_in = static_cast<uInt>(piece.size());
  if (inflateInit(&stream) != Z_OK) return false;
  std::array<Bytef, 1 << 15> scratch{};
  int state = Z_OK;
  while (state == Z_OK && stream.total_out <= max) {
    stream.next_out = scratch.data();
    stream.avail_out = scratch.size();
    state = inflate(&stream, Z_NO_FLUSH);
  }
  const bool fits = state == Z_STREAM_END && stream.total_out <= max;
  inflateEnd(&stream);
  return fits;
}

}  // namespace hackle
