// SPDX-License-Identifier: MIT
// Arrays of values of nodes, aligned to a cache line.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace hackle {

template <class T>
struct CacheAligned {
  using value_type = T;
  static constexpr std::align_val_t line{64};

  CacheAligned() = default;
  template <class Other>
  CacheAligned(const CacheAligned<Other>&) {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), line));
  }
  void deallocate(T* values, std::size_t) { ::operator delete(values, line); }

  friend bool operator==(const CacheAligned&, const CacheAligned&) { return true; }
};

template <class Real>
using Values = std::vector<Real, CacheAligned<Real>>;

template <class T>
std::size_t bytes_of(const T& values) {
  return values.size() * sizeof(typename T::value_type);
}

}  // namespace hackle
