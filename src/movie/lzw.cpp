// SPDX-License-Identifier: MIT
#include "movie/lzw.hpp"

namespace hackle {
namespace {

constexpr std::uint32_t clear_code = 256, end_code = 257, max_codes = 4096;
constexpr int first_width = 9;  // bits

class CodeStream {
 public:
  void put(std::uint32_t code, int width) {
    pending_ |= code << pending_bits_;
    for (pending_bits_ += width; pending_bits_ >= 8; pending_bits_ -= 8, pending_ >>= 8)
      bytes_.push_back(static_cast<std::uint8_t>(pending_));
  }

  std::vector<std::uint8_t> finish() {
    if (pending_bits_ > 0) bytes_.push_back(static_cast<std::uint8_t>(pending_));
    return std::move(bytes_);
  }

 private:
  std::vector<std::uint8_t> bytes_;
  std::uint32_t pending_ = 0;
  int pending_bits_ = 0;
};

// The strings found so far: a code extended by a byte is another code.
class Strings {
 public:
  Strings() { clear(); }

  void clear() {
    slots_.assign(size, empty);
    next_ = end_code + 1;
    width_ = first_width;
  }

  // Returns the code of the string `code` followed by `byte`, or null with its slot in `at_`.
  const std::uint32_t* find(std::uint32_t code, std::uint8_t byte) {
    key_ = (code << 8) | byte;
    for (at_ = (key_ * 2654435761U) >> 19; slots_[at_].key != empty.key; at_ = (at_ + 1) % size)
      if (slots_[at_].key == key_) return &slots_[at_].code;
    return nullptr;
  }

  // Gives the next code to the string that find() did not find. A reader learns it one code later,
  // and then reads wider codes.
  void add() {
    slots_[at_] = {key_, next_};
    count();
  }
  void count() {
    if (next_ == (1U << width_) && width_ < 12) ++width_;
    ++next_;
  }

  bool full() const { return next_ == max_codes; }
  int width() const { return width_; }

 private:
  struct Slot {
    std::uint32_t key, code;
  };
  static constexpr std::uint32_t size = 8192;  // twice the largest number; 32 - 19 bits
  static constexpr Slot empty{0xffffffffU, 0};

  std::vector<Slot> slots_;
  std::uint32_t next_ = 0, key_ = 0, at_ = 0;
  int width_ = 0;
};

}  // namespace

std::vector<std::uint8_t> lzw(std::span<const std::uint8_t> bytes) {
  CodeStream stream;
  Strings strings;
  stream.put(clear_code, strings.width());
  std::uint32_t code = bytes.front();
  for (const std::uint8_t byte : bytes.subspan(1)) {
    if (const std::uint32_t* longer = strings.find(code, byte)) {
      code = *longer;
      continue;
    }
    stream.put(code, strings.width());
    code = byte;
    if (!strings.full()) {
      strings.add();
      continue;
    }
    stream.put(clear_code, strings.width());
    strings.clear();
  }
  stream.put(code, strings.width());
  if (!strings.full()) strings.count();
  stream.put(end_code, strings.width());
  return stream.finish();
}

}  // namespace hackle
