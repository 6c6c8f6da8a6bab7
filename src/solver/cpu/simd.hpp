// SPDX-License-Identifier: MIT
// Vectors of HACKLE_VECTOR_BYTES bytes, in the namespace of the instruction set of a kernel. They
// use the compiler's vector types, so one source serves every machine; the few operations that
// these lack are intrinsics if available, loops otherwise. Everything is always inlined: a function
// compiled here for a wide machine must not become the copy that the linker keeps for everybody.
#pragma once

#include <cstdint>

#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

#define HACKLE_INLINE inline __attribute__((always_inline))
#define HACKLE_LAMBDA_INLINE __attribute__((always_inline))

namespace hackle::HACKLE_INSTRUCTION_SET {
namespace {

template <class Real>
struct VectorOf;
template <>
struct VectorOf<float> {
  using Type = float __attribute__((vector_size(HACKLE_VECTOR_BYTES)));
  using Bits = std::int32_t __attribute__((vector_size(HACKLE_VECTOR_BYTES)));
  using Words = std::uint32_t __attribute__((vector_size(HACKLE_VECTOR_BYTES)));
};
template <>
struct VectorOf<double> {
  using Type = double __attribute__((vector_size(HACKLE_VECTOR_BYTES)));
  using Bits = std::int64_t __attribute__((vector_size(HACKLE_VECTOR_BYTES)));
  using Words = std::uint32_t __attribute__((vector_size(HACKLE_VECTOR_BYTES / 2)));
};
template <class Real>
using Vector = typename VectorOf<Real>::Type;
template <class Real>
using Bits = typename VectorOf<Real>::Bits;
template <class Real>
inline constexpr int lanes = HACKLE_VECTOR_BYTES / sizeof(Real);

template <class Real>
HACKLE_INLINE Vector<Real> load(const Real* from) {
  Vector<Real> vector;
  __builtin_memcpy(&vector, from, sizeof vector);
  return vector;
}

template <class Real>
HACKLE_INLINE void store(Real* to, Vector<Real> vector) {
  __builtin_memcpy(to, &vector, sizeof vector);
}

template <class Real>
HACKLE_INLINE Vector<Real> every(Real value) {
  return value - Vector<Real>{};
}

// A flag per lane: a bit if the machine has masks, otherwise all ones or all zeros.
template <class Real>
struct Mask {
#if defined(__AVX512F__)
  std::uint32_t set;
#else
  Bits<Real> set;
#endif
  HACKLE_INLINE Mask operator&(Mask other) const {
    return {set & other.set};
  }
  HACKLE_INLINE Mask but_not(Mask other) const {
    return {set & ~other.set};
  }
  HACKLE_INLINE bool any() const;
  HACKLE_INLINE bool operator[](int lane) const;
};

#if defined(__AVX512F__)
template <class Real>
HACKLE_INLINE bool Mask<Real>::any() const {
  return set != 0;
}
template <class Real>
HACKLE_INLINE bool Mask<Real>::operator[](int lane) const {
  return (set >> lane & 1U) != 0;
}
HACKLE_INLINE Mask<float> above(Vector<float> a, Vector<float> b) {
  return {_mm512_cmp_ps_mask((__m512)a, (__m512)b, _CMP_GT_OQ)};
}
HACKLE_INLINE Mask<double> above(Vector<double> a, Vector<double> b) {
  return {_mm512_cmp_pd_mask((__m512d)a, (__m512d)b, _CMP_GT_OQ)};
}
HACKLE_INLINE Vector<float> select(Mask<float> mask, Vector<float> yes, Vector<float> no) {
  return (Vector<float>)_mm512_mask_blend_ps(static_cast<__mmask16>(mask.set), (__m512)no,
                                             (__m512)yes);
}
HACKLE_INLINE Vector<double> select(Mask<double> mask, Vector<double> yes, Vector<double> no) {
  return (Vector<double>)_mm512_mask_blend_pd(static_cast<__mmask8>(mask.set), (__m512d)no,
                                              (__m512d)yes);
}
#else
template <class Real>
HACKLE_INLINE bool Mask<Real>::any() const {
#if defined(__AVX__)
  return _mm256_testz_si256((__m256i)set, (__m256i)set) == 0;
#elif defined(__SSE2__)
  return _mm_movemask_epi8((__m128i)set) != 0;
#else
  bool found = false;
  for (int lane = 0; lane < lanes<Real>; ++lane) found |= set[lane] != 0;
  return found;
#endif
}
template <class Real>
HACKLE_INLINE bool Mask<Real>::operator[](int lane) const {
  return set[lane] != 0;
}
HACKLE_INLINE Mask<float> above(Vector<float> a, Vector<float> b) {
  return {a > b};
}
HACKLE_INLINE Mask<double> above(Vector<double> a, Vector<double> b) {
  return {a > b};
}
HACKLE_INLINE Vector<float> select(Mask<float> mask, Vector<float> yes, Vector<float> no) {
  return mask.set ? yes : no;
}
HACKLE_INLINE Vector<double> select(Mask<double> mask, Vector<double> yes, Vector<double> no) {
  return mask.set ? yes : no;
}
#endif

// Sets lanes where `bit` is set in consecutive words.
template <class Real>
HACKLE_INLINE Mask<Real> load_bit(const std::uint32_t* words, std::uint32_t bit) {
  typename VectorOf<Real>::Words word;
  __builtin_memcpy(&word, words, sizeof word);
#if defined(__AVX512F__)
  const auto wanted = static_cast<int>(bit);
  if constexpr (sizeof(Real) == 4)
    return {_mm512_test_epi32_mask((__m512i)word, _mm512_set1_epi32(wanted))};
  else
    return {_mm256_test_epi32_mask((__m256i)word, _mm256_set1_epi32(wanted))};
#else
  return {__builtin_convertvector(word & bit, Bits<Real>) != 0};
#endif
}

template <class Real>
HACKLE_INLINE Vector<Real> magnitude(Vector<Real> v) {
  constexpr auto sign =
      static_cast<decltype(Bits<Real>{}[0] + 0)>(std::uint64_t{1} << (8 * sizeof(Real) - 1));
  return (Vector<Real>)((Bits<Real>)v & ~sign);
}

// Return the larger, the smaller; b if either is nan.
template <class Real>
HACKLE_INLINE Vector<Real> most(Vector<Real> a, Vector<Real> b) {
#if defined(__AVX512F__)
  if constexpr (sizeof(Real) == 4)
    return (Vector<Real>)_mm512_max_ps((__m512)a, (__m512)b);
  else
    return (Vector<Real>)_mm512_max_pd((__m512d)a, (__m512d)b);
#elif defined(__AVX__)
  if constexpr (sizeof(Real) == 4)
    return (Vector<Real>)_mm256_max_ps((__m256)a, (__m256)b);
  else
    return (Vector<Real>)_mm256_max_pd((__m256d)a, (__m256d)b);
#elif defined(__SSE2__)
  if constexpr (sizeof(Real) == 4)
    return (Vector<Real>)_mm_max_ps((__m128)a, (__m128)b);
  else
    return (Vector<Real>)_mm_max_pd((__m128d)a, (__m128d)b);
#else
  return a > b ? a : b;
#endif
}

template <class Real>
HACKLE_INLINE Vector<Real> least(Vector<Real> a, Vector<Real> b) {
#if defined(__AVX512F__)
  if constexpr (sizeof(Real) == 4)
    return (Vector<Real>)_mm512_min_ps((__m512)a, (__m512)b);
  else
    return (Vector<Real>)_mm512_min_pd((__m512d)a, (__m512d)b);
#elif defined(__AVX__)
  if constexpr (sizeof(Real) == 4)
    return (Vector<Real>)_mm256_min_ps((__m256)a, (__m256)b);
  else
    return (Vector<Real>)_mm256_min_pd((__m256d)a, (__m256d)b);
#elif defined(__SSE2__)
  if constexpr (sizeof(Real) == 4)
    return (Vector<Real>)_mm_min_ps((__m128)a, (__m128)b);
  else
    return (Vector<Real>)_mm_min_pd((__m128d)a, (__m128d)b);
#else
  return a < b ? a : b;
#endif
}

template <class Real>
HACKLE_INLINE Vector<Real> square_root(Vector<Real> v) {
#if defined(__AVX512F__)
  if constexpr (sizeof(Real) == 4)
    return (Vector<Real>)_mm512_sqrt_ps((__m512)v);
  else
    return (Vector<Real>)_mm512_sqrt_pd((__m512d)v);
#elif defined(__AVX__)
  if constexpr (sizeof(Real) == 4)
    return (Vector<Real>)_mm256_sqrt_ps((__m256)v);
  else
    return (Vector<Real>)_mm256_sqrt_pd((__m256d)v);
#elif defined(__SSE2__)
  if constexpr (sizeof(Real) == 4)
    return (Vector<Real>)_mm_sqrt_ps((__m128)v);
  else
    return (Vector<Real>)_mm_sqrt_pd((__m128d)v);
#else
  for (int lane = 0; lane < lanes<Real>; ++lane)
    v[lane] = static_cast<Real>(__builtin_sqrt(v[lane]));
  return v;
#endif
}

// Returns a b + c: with two roundings, or with one if the kernel is compiled for fused arithmetic.
template <class Real>
HACKLE_INLINE Vector<Real> multiply_add(Vector<Real> a, Vector<Real> b, Vector<Real> c) {
#if !HACKLE_FUSED
  return a * b + c;
#elif defined(__AVX512F__)
  if constexpr (sizeof(Real) == 4)
    return (Vector<Real>)_mm512_fmadd_ps((__m512)a, (__m512)b, (__m512)c);
  else
    return (Vector<Real>)_mm512_fmadd_pd((__m512d)a, (__m512d)b, (__m512d)c);
#elif defined(__FMA__)
  if constexpr (sizeof(Real) == 4)
    return (Vector<Real>)_mm256_fmadd_ps((__m256)a, (__m256)b, (__m256)c);
  else
    return (Vector<Real>)_mm256_fmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
#elif defined(__aarch64__)
  if constexpr (sizeof(Real) == 4)
    return (Vector<Real>)vfmaq_f32((float32x4_t)c, (float32x4_t)a, (float32x4_t)b);
  else
    return (Vector<Real>)vfmaq_f64((float64x2_t)c, (float64x2_t)a, (float64x2_t)b);
#else
#error "no fused arithmetic for this machine"
#endif
}

// While it lives, denormal numbers count as zero on this thread: they are slow on some machines,
// and a plate at rest becomes exactly still.
class FlushDenormals {
 public:
#if defined(__x86_64__)
  HACKLE_INLINE FlushDenormals() : before_(_mm_getcsr()) {
    _mm_setcsr(before_ | 0x8040U);
  }
  HACKLE_INLINE ~FlushDenormals() {
    _mm_setcsr(before_);
  }

 private:
  unsigned before_;
#elif defined(__aarch64__)
  HACKLE_INLINE FlushDenormals() {
    asm volatile("mrs %0, fpcr" : "=r"(before_));
    asm volatile("msr fpcr, %0" : : "r"(before_ | (std::uint64_t{1} << 24)));
  }
  HACKLE_INLINE ~FlushDenormals() {
    asm volatile("msr fpcr, %0" : : "r"(before_));
  }

 private:
  std::uint64_t before_;
#endif
};

}  // namespace
}  // namespace hackle::HACKLE_INSTRUCTION_SET
