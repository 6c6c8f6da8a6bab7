// SPDX-License-Identifier: MIT
#include "movie/png_text.hpp"

#include <algorithm>
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

std::string text_in_png(std::string_view png, std::string_view keyword) {
  constexpr std::size_t signature = 8, head = 8, checksum = 4, flags = 5;
  std::string_view left = png.substr(std::min(signature, png.size()));
  while (left.size() > head) {
    std::size_t size = 0;
    for (const char byte : left.substr(0, 4)) size = (size << 8) | static_cast<unsigned char>(byte);
    const std::string_view content = left.substr(head, size);
    if (left.substr(4, 4) == "iTXt" && content.starts_with(keyword) &&
        content.size() >= keyword.size() + flags)
      return std::string(content.substr(keyword.size() + flags));
    left.remove_prefix(std::min(left.size(), head + size + checksum));
  }
  return {};
}

}  // namespace hackle
