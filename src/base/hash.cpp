// SPDX-License-Identifier: MIT
#include "base/hash.hpp"

#include <new>

#include <fmt/format.h>
#include <xxhash.h>

namespace hackle {

Hash::Hash() : state_(XXH3_createState()) {
  if (state_ == nullptr) throw std::bad_alloc();
  XXH3_64bits_reset(state_);
}

Hash::~Hash() {
  XXH3_freeState(state_);
}

void Hash::add_bytes(std::span<const std::byte> bytes) {
  XXH3_64bits_update(state_, bytes.data(), bytes.size());
}

std::string Hash::hex() const {
  return fmt::format("{:016x}", XXH3_64bits_digest(state_));
}

}  // namespace hackle
