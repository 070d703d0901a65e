// Vectors of floats behind named operations: four lanes on every x86-64, eight with AVX2.
// Both do the same IEEE operations (no fused multiply-add), so both give the same bits.
#pragma once

#include <immintrin.h>

#include <cstddef>

namespace pedzone::simd {

/// Baseline x86-64.
struct Float4 {
  static constexpr std::size_t kLanes = 4;
  __m128 v;

  static Float4 load(const float* p) { return {_mm_loadu_ps(p)}; }
  static Float4 all(float x) { return {_mm_set1_ps(x)}; }
  void store(float* p) const { _mm_storeu_ps(p, v); }
  friend Float4 operator+(Float4 a, Float4 b) { return {_mm_add_ps(a.v, b.v)}; }
  friend Float4 operator-(Float4 a, Float4 b) { return {_mm_sub_ps(a.v, b.v)}; }
  friend Float4 operator*(Float4 a, Float4 b) { return {_mm_mul_ps(a.v, b.v)}; }
  friend Float4 operator/(Float4 a, Float4 b) { return {_mm_div_ps(a.v, b.v)}; }
  friend Float4 sqrt(Float4 a) { return {_mm_sqrt_ps(a.v)}; }
  /// The larger; b where a is not a number.
  friend Float4 larger(Float4 a, Float4 b) { return {_mm_max_ps(a.v, b.v)}; }
  friend Float4 absolute(Float4 a) { return {_mm_andnot_ps(_mm_set1_ps(-0.0F), a.v)}; }
  /// All bits set where true.
  friend Float4 at_least(Float4 a, Float4 b) { return {_mm_cmpge_ps(a.v, b.v)}; }
  friend Float4 both(Float4 a, Float4 b) { return {_mm_and_ps(a.v, b.v)}; }
};

#ifdef __AVX2__
struct Float8 {
  static constexpr std::size_t kLanes = 8;
  __m256 v;

  static Float8 load(const float* p) { return {_mm256_loadu_ps(p)}; }
  static Float8 all(float x) { return {_mm256_set1_ps(x)}; }
  void store(float* p) const { _mm256_storeu_ps(p, v); }
  friend Float8 operator+(Float8 a, Float8 b) { return {_mm256_add_ps(a.v, b.v)}; }
  friend Float8 operator-(Float8 a, Float8 b) { return {_mm256_sub_ps(a.v, b.v)}; }
  friend Float8 operator*(Float8 a, Float8 b) { return {_mm256_mul_ps(a.v, b.v)}; }
  friend Float8 operator/(Float8 a, Float8 b) { return {_mm256_div_ps(a.v, b.v)}; }
  friend Float8 sqrt(Float8 a) { return {_mm256_sqrt_ps(a.v)}; }
  friend Float8 larger(Float8 a, Float8 b) { return {_mm256_max_ps(a.v, b.v)}; }
  friend Float8 absolute(Float8 a) { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.v)}; }
  friend Float8 at_least(Float8 a, Float8 b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_GE_OQ)}; }
  friend Float8 both(Float8 a, Float8 b) { return {_mm256_and_ps(a.v, b.v)}; }
};
#endif

}  // namespace pedzone::simd
