// SPDX-License-Identifier: MIT
// A delta is a list of groups of rows, from the top: two bytes, of which the upper two bits are the
// kind and the others the number of rows less one; after that, for each row of the kind `coded`,
// its pixels. The first byte of pixels tells what they are:
//   00kkkkkk            the k-th recent colour
//   01nnnnnn            n + 1 times the last pixel
//   10nnnnnn            n + 1 pixels as in the picture before
//   11gggggg rrrrbbbb   the last pixel, with green changed by g - 31, red by this and r - 8, blue
//   by
//                       this and b - 8
//   11111111 and four bytes of a pixel
#include "movie/frame_delta.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace hackle {
namespace {

enum class Rows : unsigned { as_before, as_above, coded };

constexpr unsigned kind_shift = 14, max_rows = 1U << kind_shift;
constexpr unsigned index_code = 0x00, run_code = 0x40, skip_code = 0x80, near_code = 0xc0;
constexpr unsigned pixel_code = 0xff, code_mask = 0xc0, count_mask = 0x3f, max_count = 64;
constexpr int green_zero = 31, other_zero = 8;

using Pixel = std::uint32_t;  // blue in the lowest byte, then green, red, alpha

Pixel pixel_at(const std::uint8_t* row, int x) {
  Pixel pixel = 0;
  std::memcpy(&pixel, row + static_cast<std::ptrdiff_t>(4) * x, sizeof pixel);
  return pixel;
}

void put(Pixel pixel, std::uint8_t* row, int x) {
  std::memcpy(row + static_cast<std::ptrdiff_t>(4) * x, &pixel, sizeof pixel);
}

int channel(Pixel pixel, int k) {
  return static_cast<int>(pixel >> (8 * k) & 0xffU);
}

// Writer and reader know the same: the last pixel and recent ones.
struct Memory {
  Pixel last = 0;
  std::array<Pixel, max_count> recent{};

  static std::size_t place_of(Pixel pixel) { return pixel * 2654435761U >> 26U; }
  void learn(Pixel pixel) {
    last = pixel;
    recent[place_of(pixel)] = pixel;
  }
};

// Returns the two bytes of a pixel that is near the last one, or 0.
unsigned near_bytes(Pixel last, Pixel pixel) {
  const auto change = [&](int k) {
    return static_cast<std::int8_t>(channel(pixel, k) - channel(last, k));
  };
  const int green = change(1) + green_zero;
  const int red = change(2) - change(1) + other_zero, blue = change(0) - change(1) + other_zero;
  const auto fits = [](int value, int end) { return value >= 0 && value < end; };
  if (channel(pixel, 3) != channel(last, 3) || !fits(green, 63) || !fits(red, 16) ||
      !fits(blue, 16))
    return 0;
  return near_code + static_cast<unsigned>(green) + (static_cast<unsigned>(red * 16 + blue) << 8U);
}

Pixel pixel_near(Pixel last, unsigned first, unsigned second) {
  const int green = static_cast<int>(first - near_code) - green_zero;
  const int red = green + static_cast<int>(second >> 4U) - other_zero;
  const int blue = green + static_cast<int>(second & 15U) - other_zero;
  const auto changed = [&](int k, int by) {
    return static_cast<Pixel>(static_cast<std::uint8_t>(channel(last, k) + by)) << (8 * k);
  };
  return changed(0, blue) | changed(1, green) | changed(2, red) | (last & 0xff000000U);
}

// Returns how many pixels from x on, at most as many as a code can count, fulfil the condition.
template <class Condition>
int count_while(int x, int width, const Condition& holds) {
  const int end = std::min(width, x + static_cast<int>(max_count));
  int at = x;
  while (at < end && holds(at)) ++at;
  return at - x;
}

void add_pixel(Pixel pixel, Memory& memory, Bytes& bytes) {
  const std::size_t place = Memory::place_of(pixel);
  if (memory.recent[place] == pixel)
    bytes.number(index_code + place, 1);
  else if (const unsigned both = near_bytes(memory.last, pixel); both != 0)
    bytes.number(both, 2);
  else
    bytes.number(pixel_code, 1).number(pixel, 4);
  memory.learn(pixel);
}

void add_row(const std::uint8_t* row, const std::uint8_t* before, int width, Memory& memory,
             Bytes& bytes) {
  for (int x = 0; x < width;) {
    const auto as_before = [&](int at) { return pixel_at(row, at) == pixel_at(before, at); };
    const auto as_last = [&](int at) { return pixel_at(row, at) == memory.last; };
    if (const int skipped = count_while(x, width, as_before); skipped > 0) {
      bytes.number(skip_code + static_cast<unsigned>(skipped) - 1, 1);
      x += skipped;
    } else if (const int repeated = count_while(x, width, as_last); repeated > 0) {
      bytes.number(run_code + static_cast<unsigned>(repeated) - 1, 1);
      x += repeated;
    } else {
      add_pixel(pixel_at(row, x++), memory, bytes);
    }
  }
}

// Takes bytes one after another; zeros, and `ended`, behind the last.
class Source {
 public:
  explicit Source(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint32_t number(int count) {
    std::uint32_t value = 0;
    for (int k = 0; k < count; ++k) value |= static_cast<std::uint32_t>(next()) << (8 * k);
    return value;
  }
  bool ended() const { return ended_; }
  bool empty() const { return bytes_.empty(); }

 private:
  std::uint8_t next() {
    ended_ |= bytes_.empty();
    if (ended_) return 0;
    const std::uint8_t byte = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return byte;
  }
  std::span<const std::uint8_t> bytes_;
  bool ended_ = false;
};

Pixel taken_pixel(unsigned code, Memory& memory, Source& source) {
  Pixel pixel = 0;
  if (code == pixel_code)
    pixel = source.number(4);
  else if ((code & code_mask) == near_code)
    pixel = pixel_near(memory.last, code, source.number(1));
  else
    pixel = memory.recent[code & count_mask];
  memory.learn(pixel);
  return pixel;
}

bool take_row(std::uint8_t* row, int width, Memory& memory, Source& source) {
  for (int x = 0; x < width;) {
    const unsigned code = source.number(1);
    if (source.ended()) return false;
    const unsigned kind = code & code_mask;
    if (kind != run_code && kind != skip_code) {
      put(taken_pixel(code, memory, source), row, x++);
      continue;
    }
    const int count = static_cast<int>(code & count_mask) + 1;
    if (count > width - x) return false;
    for (int end = x + count; x < end; ++x)
      if (kind == run_code) put(memory.last, row, x);
  }
  return true;
}

std::uint8_t* row_of(Image& image, int y) {
  return image.pixels.data() + static_cast<std::ptrdiff_t>(y) * image.stride();
}

}  // namespace

Bytes advance_by_delta(Image& before, const Image& now) {
  const auto row_now = [&](int y) {
    return now.pixels.data() + static_cast<std::ptrdiff_t>(y) * now.stride();
  };
  const auto bytes_a_row = static_cast<std::size_t>(now.stride());
  const auto kind_of = [&](int y) {
    if (std::memcmp(row_now(y), row_of(before, y), bytes_a_row) == 0) return Rows::as_before;
    const bool repeats = y > 0 && std::memcmp(row_now(y), row_now(y - 1), bytes_a_row) == 0;
    return repeats ? Rows::as_above : Rows::coded;
  };
  Bytes bytes;
  Memory memory;
  for (int y = 0; y < now.height;) {
    const Rows kind = kind_of(y);
    const int first = y;
    while (y < now.height && y - first < static_cast<int>(max_rows) && kind_of(y) == kind) ++y;
    bytes.number((static_cast<unsigned>(kind) << kind_shift) + static_cast<unsigned>(y - first - 1),
                 2);
    if (kind == Rows::as_before) continue;
    for (int row = first; row < y; ++row) {
      if (kind == Rows::coded) add_row(row_now(row), row_of(before, row), now.width, memory, bytes);
      std::memcpy(row_of(before, row), row_now(row), bytes_a_row);
    }
  }
  return bytes;
}

bool apply_delta(std::span<const std::uint8_t> delta, Image& picture) {
  Source source(delta);
  Memory memory;
  for (int y = 0; y < picture.height;) {
    const unsigned head = source.number(2);
    const auto kind = static_cast<Rows>(head >> kind_shift);
    const int end = y + static_cast<int>(head % max_rows) + 1;
    if (source.ended() || kind > Rows::coded || end > picture.height) return false;
    if (kind == Rows::as_above && y == 0) return false;
    if (kind == Rows::as_before) y = end;
    for (; y < end; ++y) {
      if (kind == Rows::as_above)
        std::memcpy(row_of(picture, y), row_of(picture, y - 1),
                    static_cast<std::size_t>(picture.stride()));
      else if (!take_row(row_of(picture, y), picture.width, memory, source))
        return false;
    }
  }
  return source.empty() && !source.ended();
}

}  // namespace hackle
