// SPDX-License-Identifier: MIT
// The memory that the values of a Lua state take, with an upper limit.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hackle {

inline constexpr std::size_t default_lua_memory = std::size_t{1024} << 20U;  // bytes

// Counts what Lua asks for. Beyond the limit Lua is told that there is none left: it collects its
// garbage, asks once more, and then raises "not enough memory", which a script may catch. What our
// own objects hold outside of Lua counts where they say so with hold().
class LuaMemory {
 public:
  explicit LuaMemory(std::size_t limit) : limit_(limit) {}  // bytes
  LuaMemory(const LuaMemory&) = delete;
  LuaMemory& operator=(const LuaMemory&) = delete;

  std::size_t limit() const { return limit_; }
  std::size_t used() const { return used_; }

  // Memory outside of Lua that an object in it takes, and gives back when it is collected. False
  // when there is no room for it.
  bool hold(std::size_t bytes);
  void release(std::size_t bytes) { used_ -= bytes; }

  // A lua_Alloc; `memory` is a LuaMemory.
  static void* allocate(void* memory, void* block, std::size_t old_size, std::size_t size);

  // How many blocks had been made before this one. Addresses differ from process to process, the
  // order in which a script makes things does not.
  static std::uint64_t birth_of(const void* block);
  const void* newest() const { return newest_; }

 private:
  std::size_t limit_;
  std::size_t used_ = 0;
  std::uint64_t births_ = 0;
  const void* newest_ = nullptr;  // block that was made last
};

}  // namespace hackle
