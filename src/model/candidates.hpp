// The walking directions that a person compares, as offsets from its heading.
#pragma once

#include <cstddef>
#include <vector>

namespace pedzone {

/// Number of directions in the candidate field (model.md; Moussaid 2011 leaves it open).
inline constexpr std::size_t kMainDirections = 61;
/// Step of the directions in the rest of the circle [deg].
inline constexpr double kRestStepDegrees = 5.0;
/// Directions are stored in groups of this many, the widest vector in use.
inline constexpr std::size_t kDirectionGroup = 8;

/// The tables of Candidates, for the kernel.
struct CandidateView {
  const float *cosine, *sine;            ///< of the offset
  const float *half_cosine, *half_sine;  ///< of half the offset
  std::size_t padded;                    ///< length of the tables
};

/// Offsets and the trigonometry of them. The main directions, right (clockwise) to left, stand at
/// [0, 61); the rest of the circle from main_padded() on: right ones, then left ones, then 180°.
/// Of two mirrored directions the right one has the lower index. Tables are mirror images to the
/// bit: the entry of −o is that of o with the sign of its sines changed.
class Candidates {
 public:
  /// `field` [deg] [10, 180]: half angle of the main directions.
  explicit Candidates(double field = 75.0);

  double field() const { return field_; }
  std::size_t main_count() const { return kMainDirections; }
  std::size_t main_padded() const { return 64; }
  std::size_t rest_count() const { return rest_count_; }
  std::size_t padded() const { return offset_.size(); }

  /// [rad] offset from the heading; 0 in the padding.
  double offset(std::size_t k) const { return offset_[k]; }
  const float* cosine() const { return cosine_.data(); }
  const float* sine() const { return sine_.data(); }
  CandidateView view() const {
    return {cosine_.data(), sine_.data(), half_cosine_.data(), half_sine_.data(), padded()};
  }
  /// 0 for a direction, infinity in the padding.
  const float* excluded() const { return excluded_.data(); }

 private:
  void put(std::size_t k, double offset);

  double field_;
  std::size_t rest_count_ = 0;
  std::vector<double> offset_;
  std::vector<float> cosine_, sine_, half_cosine_, half_sine_, excluded_;
};

/// Most directions there can be (field 10°), padding included.
inline constexpr std::size_t kMaxDirections = 64 + 72;

}  // namespace pedzone
