// Vectors of floats behind named operations: four lanes on every x86-64, eight with AVX2.
// Both do the same IEEE operations (no fused multiply-add, no approximate roots), so both give the
// same bits.
#pragma once

#include <immintrin.h>

#include <cstddef>
#include <cstdint>

#include "model/fixed_point.hpp"

namespace pedzone::simd {

/// Baseline x86-64.
struct Float4 {
  static constexpr std::size_t kLanes = 4;
  __m128 v;

  static Float4 load(const float* p) { return {_mm_loadu_ps(p)}; }
  static Float4 all(float x) { return {_mm_set1_ps(x)}; }
  /// [m] p[i] − origin, both lattice coordinates.
  static Float4 metres(const std::int32_t* p, std::int32_t origin) {
    const __m128i d =
        _mm_sub_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p)), _mm_set1_epi32(origin));
    return {_mm_mul_ps(_mm_cvtepi32_ps(d), _mm_set1_ps(kMetrePerLattice))};
  }
  void store(float* p) const { _mm_storeu_ps(p, v); }
  friend Float4 operator+(Float4 a, Float4 b) { return {_mm_add_ps(a.v, b.v)}; }
  friend Float4 operator-(Float4 a, Float4 b) { return {_mm_sub_ps(a.v, b.v)}; }
  friend Float4 operator*(Float4 a, Float4 b) { return {_mm_mul_ps(a.v, b.v)}; }
  friend Float4 operator/(Float4 a, Float4 b) { return {_mm_div_ps(a.v, b.v)}; }
  friend Float4 sqrt(Float4 a) { return {_mm_sqrt_ps(a.v)}; }
  /// The larger (smaller); b where a is not a number.
  friend Float4 larger(Float4 a, Float4 b) { return {_mm_max_ps(a.v, b.v)}; }
  friend Float4 smaller(Float4 a, Float4 b) { return {_mm_min_ps(a.v, b.v)}; }
  friend Float4 absolute(Float4 a) { return {_mm_andnot_ps(_mm_set1_ps(-0.0F), a.v)}; }
  /// a ≥ 0 with the sign of b.
  friend Float4 signed_as(Float4 a, Float4 b) {
    return {_mm_or_ps(a.v, _mm_and_ps(_mm_set1_ps(-0.0F), b.v))};
  }
  /// All bits of a lane set where true, which both() and either() combine.
  friend Float4 at_least(Float4 a, Float4 b) { return {_mm_cmpge_ps(a.v, b.v)}; }
  friend Float4 more(Float4 a, Float4 b) { return {_mm_cmpgt_ps(a.v, b.v)}; }
  friend Float4 both(Float4 a, Float4 b) { return {_mm_and_ps(a.v, b.v)}; }
  friend Float4 either(Float4 a, Float4 b) { return {_mm_or_ps(a.v, b.v)}; }
  /// a where b is not true.
  friend Float4 without(Float4 a, Float4 b) { return {_mm_andnot_ps(b.v, a.v)}; }
  /// Bit i: lane i is true.
  friend std::uint32_t bits(Float4 a) { return static_cast<std::uint32_t>(_mm_movemask_ps(a.v)); }
  friend float largest(Float4 a) {
    const __m128 b = _mm_max_ps(a.v, _mm_movehl_ps(a.v, a.v));
    return _mm_cvtss_f32(_mm_max_ss(b, _mm_shuffle_ps(b, b, 1)));
  }
  friend float smallest(Float4 a) {
    const __m128 b = _mm_min_ps(a.v, _mm_movehl_ps(a.v, a.v));
    return _mm_cvtss_f32(_mm_min_ss(b, _mm_shuffle_ps(b, b, 1)));
  }

  /// Writes the lanes whose bit is set one behind the other; kLanes values may be overwritten.
  class Packer {
   public:
    explicit Packer(std::uint32_t lanes) : lanes_(lanes) {}
    void store(Float4 a, float* p) const {
      alignas(16) float value[kLanes];
      _mm_store_ps(value, a.v);
      for (std::uint32_t left = lanes_; left != 0; left &= left - 1) {
        *p++ = value[__builtin_ctz(left)];
      }
    }

   private:
    std::uint32_t lanes_;
  };
};

#ifdef __AVX2__
/// For each set of eight lanes their numbers, ascending.
struct LaneOrder {
  alignas(32) std::int32_t lane[256][8] = {};
  constexpr LaneOrder() {
    for (int set = 0; set < 256; ++set) {
      int count = 0;
      for (int i = 0; i < 8; ++i) {
        if ((set >> i & 1) != 0) lane[set][count++] = i;
      }
    }
  }
};
inline constexpr LaneOrder kLaneOrder{};

/// With AVX2.
struct Float8 {
  static constexpr std::size_t kLanes = 8;
  __m256 v;

  static Float8 load(const float* p) { return {_mm256_loadu_ps(p)}; }
  static Float8 all(float x) { return {_mm256_set1_ps(x)}; }
  static Float8 metres(const std::int32_t* p, std::int32_t origin) {
    const __m256i d = _mm256_sub_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p)),
                                       _mm256_set1_epi32(origin));
    return {_mm256_mul_ps(_mm256_cvtepi32_ps(d), _mm256_set1_ps(kMetrePerLattice))};
  }
  void store(float* p) const { _mm256_storeu_ps(p, v); }
  friend Float8 operator+(Float8 a, Float8 b) { return {_mm256_add_ps(a.v, b.v)}; }
  friend Float8 operator-(Float8 a, Float8 b) { return {_mm256_sub_ps(a.v, b.v)}; }
  friend Float8 operator*(Float8 a, Float8 b) { return {_mm256_mul_ps(a.v, b.v)}; }
  friend Float8 operator/(Float8 a, Float8 b) { return {_mm256_div_ps(a.v, b.v)}; }
  friend Float8 sqrt(Float8 a) { return {_mm256_sqrt_ps(a.v)}; }
  friend Float8 larger(Float8 a, Float8 b) { return {_mm256_max_ps(a.v, b.v)}; }
  friend Float8 smaller(Float8 a, Float8 b) { return {_mm256_min_ps(a.v, b.v)}; }
  friend Float8 absolute(Float8 a) { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.v)}; }
  friend Float8 signed_as(Float8 a, Float8 b) {
    return {_mm256_or_ps(a.v, _mm256_and_ps(_mm256_set1_ps(-0.0F), b.v))};
  }
  friend Float8 at_least(Float8 a, Float8 b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_GE_OQ)}; }
  friend Float8 more(Float8 a, Float8 b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ)}; }
  friend Float8 both(Float8 a, Float8 b) { return {_mm256_and_ps(a.v, b.v)}; }
  friend Float8 either(Float8 a, Float8 b) { return {_mm256_or_ps(a.v, b.v)}; }
  friend Float8 without(Float8 a, Float8 b) { return {_mm256_andnot_ps(b.v, a.v)}; }
  friend std::uint32_t bits(Float8 a) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(a.v));
  }
  friend float largest(Float8 a) {
    const __m128 b = _mm_max_ps(_mm256_castps256_ps128(a.v), _mm256_extractf128_ps(a.v, 1));
    const __m128 c = _mm_max_ps(b, _mm_movehl_ps(b, b));
    return _mm_cvtss_f32(_mm_max_ss(c, _mm_shuffle_ps(c, c, 1)));
  }
  friend float smallest(Float8 a) {
    const __m128 b = _mm_min_ps(_mm256_castps256_ps128(a.v), _mm256_extractf128_ps(a.v, 1));
    const __m128 c = _mm_min_ps(b, _mm_movehl_ps(b, b));
    return _mm_cvtss_f32(_mm_min_ss(c, _mm_shuffle_ps(c, c, 1)));
  }

  class Packer {
   public:
    explicit Packer(std::uint32_t lanes)
        : order_(_mm256_load_si256(reinterpret_cast<const __m256i*>(kLaneOrder.lane[lanes]))) {}
    void store(Float8 a, float* p) const {
      _mm256_storeu_ps(p, _mm256_permutevar8x32_ps(a.v, order_));
    }

   private:
    __m256i order_;
  };
};
#endif

}  // namespace pedzone::simd
