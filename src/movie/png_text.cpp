// SPDX-License-Identifier: MIT
#include "movie/png_text.hpp"

#include <string>

#include "movie/ffmpeg.hpp"

namespace hackle {
namespace {

void add_big_endian(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.number(value >> shift, 1);
}

}  // namespace

Bytes png_text(std::string_view keyword, std::string_view text) {
  // Not compressed, without a language.
  Bytes content;
  content.add("iTXt").add(keyword).number(0, 5).add(text);
  const auto all = content.all();
  const std::uint32_t start = ~0U;
  Bytes chunk;
  add_big_endian(chunk, static_cast<std::uint32_t>(all.size() - 4));
  chunk.add(all);
  add_big_endian(chunk, ~av::ffmpeg().av_crc(av::ffmpeg().av_crc_get_table(AV_CRC_32_IEEE_LE),
                                             start, all.data(), all.size()));
  return chunk;
}

}  // namespace hackle
