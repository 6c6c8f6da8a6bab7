// SPDX-License-Identifier: MIT
// A hash of raw bytes: equal hashes mean equal bits.
#pragma once

#include <cstddef>
#include <span>
#include <string>

struct XXH3_state_s;

namespace hackle {

// XXH3 with 64 bits. The hash is the same on every little-endian machine.
class Hash {
 public:
  Hash();
  ~Hash();
  Hash(Hash&&) = delete;

  template <class T>
  void add(std::span<const T> values) {
    add_bytes(std::as_bytes(values));
  }
  // Returns sixteen hexadecimal digits.
  std::string hex() const;

 private:
  void add_bytes(std::span<const std::byte> bytes);
  XXH3_state_s* state_;
};

}  // namespace hackle
