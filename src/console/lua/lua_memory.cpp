// SPDX-License-Identifier: MIT
#include "console/lua/lua_memory.hpp"

#include <cstdlib>
#include <cstring>

namespace hackle {

namespace {

// Stored before each block: its creation number. Lua and our objects need no larger alignment.
using Birth = std::uint64_t;

void* with_birth(void* block) {
  return block == nullptr ? nullptr : static_cast<char*>(block) - sizeof(Birth);
}

}  // namespace

bool LuaMemory::hold(std::size_t bytes) {
  if (bytes > limit_ - used_) return false;
  used_ += bytes;
  return true;
}

void* LuaMemory::allocate(void* memory, void* block, std::size_t old_size, std::size_t size) {
  LuaMemory& self = *static_cast<LuaMemory*>(memory);
  if (block == nullptr) old_size = 0;  // Lua then passes the kind of the object
  if (size == 0) {
    std::free(with_birth(block));
    self.used_ -= old_size;
    return nullptr;
  }
  // Lua relies on shrinking never to fail.
  const bool grows = size > old_size;
  if (grows && size - old_size > self.limit_ - self.used_) return nullptr;
  void* moved = std::realloc(with_birth(block), sizeof(Birth) + size);
  if (moved == nullptr) return grows ? nullptr : block;
  self.used_ += size - old_size;
  void* own = static_cast<char*>(moved) + sizeof(Birth);
  if (block == nullptr) {
    std::memcpy(moved, &self.births_, sizeof(Birth));
    ++self.births_;
    self.newest_ = own;
  }
  return own;
}

std::uint64_t LuaMemory::birth_of(const void* block) {
  Birth birth = 0;
  std::memcpy(&birth, static_cast<const char*>(block) - sizeof(Birth), sizeof(Birth));
  return birth;
}

}  // namespace hackle
