// SPDX-License-Identifier: MIT
#include "movie/gif_film.hpp"

#include <algorithm>
#include <cmath>

#include "movie/lzw.hpp"

namespace hackle {
namespace {

constexpr std::int64_t palette_at = 13;  // after signature and size of the screen
constexpr int max_delay = 65535;
constexpr std::size_t max_in_block = 255;

// Writes blocks of at most 255 bytes, ended by an empty one.
void add_blocks(Bytes& bytes, std::span<const std::uint8_t> data) {
  while (!data.empty()) {
    const auto block = data.first(std::min(data.size(), max_in_block));
    bytes.number(block.size(), 1).add(block);
    data = data.subspan(block.size());
  }
  bytes.number(0, 1);
}

Bytes palette_bytes(const Palette& palette) {
  Bytes bytes;
  for (const Palette::Colour& colour : palette.colours())
    bytes.number(colour.red, 1).number(colour.green, 1).number(colour.blue, 1);
  return bytes;
}

std::int64_t tick_of(std::int64_t frame, double fps) {
  return std::llround(100.0 * static_cast<double>(frame) / fps);
}

}  // namespace

GifFilm::GifFilm(const std::filesystem::path& path, const MovieFormat& format)
    : width_(format.width), height_(format.height), fps_(format.fps), file_(path) {
  write_head(format);
}

void GifFilm::write_head(const MovieFormat& format) {
  Bytes head;
  head.add("GIF89a").number(width_, 2).number(height_, 2);
  head.number(0xf7, 1).number(0, 2);  // a palette of 256 colours for all frames
  head.add(palette_bytes(palette_).all());
  head.add("\x21\xff\x0bNETSCAPE2.0").number(3, 1).number(1, 1).number(0, 3);  // loops for ever
  for (const std::string& text : {format.title, format.comment}) {
    if (text.empty()) continue;
    head.add("\x21\xfe");
    add_blocks(head, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  }
  file_.append(head.add(";"));
}

void GifFilm::add(const Image& image) {
  const int taken = palette_.taken();
  std::vector<std::uint8_t> places = palette_.places_of(image);
  if (palette_.taken() != taken) file_.write(palette_bytes(palette_), palette_at);
  const auto ticks = static_cast<int>(tick_of(next_ + 1, fps_) - tick_of(next_, fps_));
  ++next_;
  const Part part = changed_part(places);
  if (part.width == 0 && delay_ + ticks <= max_delay) return prolong(ticks);
  write_part(part, places, ticks);
  shown_ = std::move(places);
}

GifFilm::Part GifFilm::changed_part(const std::vector<std::uint8_t>& places) const {
  if (shown_.empty()) return {0, 0, width_, height_};
  int left = width_, right = -1, top = height_, bottom = -1;
  for (int y = 0; y < height_; ++y) {
    const auto row = places.begin() + static_cast<std::ptrdiff_t>(y) * width_;
    const auto old = shown_.begin() + static_cast<std::ptrdiff_t>(y) * width_;
    const auto first = std::mismatch(row, row + width_, old).first - row;
    if (first == width_) continue;
    auto last = static_cast<std::ptrdiff_t>(width_) - 1;
    while (row[last] == old[last]) --last;
    left = std::min(left, static_cast<int>(first));
    right = std::max(right, static_cast<int>(last));
    top = std::min(top, y);
    bottom = y;
  }
  if (right < 0) return {};
  return {left, top, right - left + 1, bottom - top + 1};
}

// Pixels equal to the previous frame are transparent: long runs, which compress well.
std::vector<std::uint8_t> GifFilm::pixels_of(const Part& part,
                                             const std::vector<std::uint8_t>& places) const {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height));
  for (int y = part.y; y < part.y + part.height; ++y)
    for (int x = part.x; x < part.x + part.width; ++x) {
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                      static_cast<std::size_t>(x);
      const bool same = !shown_.empty() && shown_[at] == places[at];
      pixels.push_back(same ? Palette::transparent : places[at]);
    }
  return pixels;
}

void GifFilm::write_part(const Part& part, const std::vector<std::uint8_t>& places, int delay) {
  const Part drawn{part.x, part.y, std::max(part.width, 1), std::max(part.height, 1)};
  constexpr int keep_below_and_see_through = 0x05;
  const std::int64_t at = file_.size() - 1;  // overwrites the end mark
  Bytes frame;
  frame.add("\x21\xf9\x04").number(keep_below_and_see_through, 1).number(delay, 2);
  frame.number(Palette::transparent, 1).number(0, 1);
  frame.add(",").number(drawn.x, 2).number(drawn.y, 2);
  frame.number(drawn.width, 2).number(drawn.height, 2).number(0, 1).number(8, 1);
  add_blocks(frame, lzw(pixels_of(drawn, places)));
  file_.write(frame.add(";"), at);
  delay_at_ = at + 4;
  delay_ = delay;
}

void GifFilm::prolong(int ticks) {
  delay_ += ticks;
  file_.write(Bytes().number(delay_, 2), delay_at_);
}

}  // namespace hackle
