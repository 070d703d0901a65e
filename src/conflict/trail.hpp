// Where somebody has been in the last seconds.
#pragma once

#include <cstddef>
#include <vector>

namespace pedzone {

/// The latest poses, the newest first. Pose has members `time` [s], ascending as they are pushed,
/// and `travelled` [m]: no point of the body has moved farther between two poses than the
/// difference. The poses k + 1 and k bound piece k of the way; between them all moves evenly.
template <typename Pose>
class Trail {
 public:
  std::size_t size() const { return size_; }
  /// Pose k, 0 the newest; k < size().
  const Pose& operator[](std::size_t k) const {
    return ring_[(newest_ + ring_.size() - k) & (ring_.size() - 1)];
  }

  void clear() { size_ = 0; }

  /// Adds a pose and forgets those not needed for the way since `since` [s].
  void push(const Pose& pose, double since) {
    while (size_ > 1 && (*this)[size_ - 2].time <= since) --size_;
    if (size_ == ring_.size()) grow();
    newest_ = (newest_ + 1) & (ring_.size() - 1);
    ring_[newest_] = pose;
    ++size_;
  }

 private:
  void grow() {
    std::vector<Pose> larger(ring_.empty() ? 8 : 2 * ring_.size());
    for (std::size_t k = 0; k < size_; ++k) larger[size_ - 1 - k] = (*this)[k];
    newest_ = size_ > 0 ? size_ - 1 : larger.size() - 1;
    ring_ = std::move(larger);
  }

  std::vector<Pose> ring_;  ///< its size is a power of two
  std::size_t newest_ = 0, size_ = 0;
};

}  // namespace pedzone
