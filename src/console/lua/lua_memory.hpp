// SPDX-License-Identifier: MIT
// The memory of the values in a Lua state, with an upper limit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace hackle {

inline constexpr std::size_t default_lua_memory = std::size_t{1024} << 20U;  // bytes

// Counts Lua's allocations. Beyond the limit they fail: Lua collects its garbage, tries again, and
// then raises "not enough memory", which a script may catch. Memory of our objects outside of Lua
// counts if they report it with hold().
class LuaMemory {
 public:
  explicit LuaMemory(std::size_t limit) : limit_(limit) {}  // bytes
  LuaMemory(const LuaMemory&) = delete;
  LuaMemory& operator=(const LuaMemory&) = delete;

  std::size_t limit() const { return limit_; }
  std::size_t used() const { return used_; }
  // Forgets the limit: finalizers that have no memory for their call would never be called.
  void lift_limit() { limit_ = std::numeric_limits<std::size_t>::max(); }

  // Counts memory outside of Lua that an object in Lua takes and releases when it is collected.
  // Returns false if there is no room for it.
  bool hold(std::size_t bytes);
  void release(std::size_t bytes) { used_ -= bytes; }

  // A lua_Alloc; `memory` is a LuaMemory.
  static void* allocate(void* memory, void* block, std::size_t old_size, std::size_t size);

  // Returns how many blocks had been allocated before this one. Addresses differ from process to
  // process; the order of creation does not.
  static std::uint64_t birth_of(const void* block);
  const void* newest() const { return newest_; }

 private:
  std::size_t limit_;
  std::size_t used_ = 0;
  std::uint64_t births_ = 0;
  const void* newest_ = nullptr;  // last allocated block
};

}  // namespace hackle
