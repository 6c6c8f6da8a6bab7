// SPDX-License-Identifier: MIT
#include "console/lua_memory.hpp"

#include <cstdlib>

namespace hackle {

bool LuaMemory::hold(std::size_t bytes) {
  if (bytes > limit_ - used_) return false;
  used_ += bytes;
  return true;
}

void* LuaMemory::allocate(void* memory, void* block, std::size_t old_size, std::size_t size) {
  LuaMemory& self = *static_cast<LuaMemory*>(memory);
  if (block == nullptr) old_size = 0;  // it was the kind of the object
  if (size == 0) {
    std::free(block);
    self.used_ -= old_size;
    return nullptr;
  }
  // Lua relies on it that shrinking never fails.
  const bool grows = size > old_size;
  if (grows && size - old_size > self.limit_ - self.used_) return nullptr;
  void* moved = std::realloc(block, size);
  if (moved == nullptr) return grows ? nullptr : block;
  self.used_ += size - old_size;
  return moved;
}

}  // namespace hackle
