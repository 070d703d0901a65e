// Scores of walking models against recordings: figures of a set of persons, with intervals.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "validation/measures.hpp"
#include "validation/replay.hpp"

namespace pedzone {

/// [m] persons whose clearance gets below this interact (validation.md, protocol 5).
inline constexpr double kInteracting = 3.0;

/// One scored person: recorded, and as one model walked it in one seed.
struct ScoredPerson {
  std::uint32_t clip = 0, person = 0;  ///< indices
  Measures recorded, walked;
  double straight_clearance = 0.0;  ///< [m] as Measures::clearance, had it walked straight to its
                                    ///< goal at its own speed
};

enum class Figure {
  kInside,
  kClose,
  kPushed,
  kPushWay,
  kPushSpeed,
  kRunInto,
  kClearance,
  kClearanceLow,
  kClearanceKs,
  kDeviation,
  kDeviationKs,
  kSpeed,
  kLeastSpeed,
  kLeastSpeedKs,
  kFirst,
  kFirstCount,
  kFirstOfAll,
  kFirstClose,
  kFirstCloseCount,
  kFirstCloseOfAll,
  kPet,
  kTtc,
  kAde,
  kFde,
  kCount
};
inline constexpr std::size_t kFigures = static_cast<std::size_t>(Figure::kCount);
using Figures = std::array<double, kFigures>;  ///< NaN where there is nobody to take it from

struct FigureInfo {
  std::string_view key, title, unit, meaning;
  double scale;  ///< from what is stored to what tables print
  int digits;
  /// Of several seeds it is the mean; of a greatest value the greatest, and without an interval; a
  /// number of persons has none either.
  enum class Kind { kMean, kGreatest, kCount };
  Kind kind = Kind::kMean;
  bool has_interval() const { return kind == Kind::kMean; }
};
const std::array<FigureInfo, kFigures>& figure_list();

/// Figures of the walked ways against the recorded ones; of the recorded ones by themselves where
/// `recorded`.
Figures figures_of(std::span<const ScoredPerson* const> persons, bool recorded = false);

/// All persons of one model in each seed. Every seed has the same persons in the same order.
using ScoredRuns = std::vector<std::vector<ScoredPerson>>;

/// Tracks that count: at least 3 s and 2 m (validation.md, protocol 5).
bool counts(const PersonTrack& track);

/// Replays all clips in seeds [1, seeds] and measures the persons that count; clips and seeds in
/// parallel, results independent of it.
ScoredRuns score(const std::vector<Clip>& clips, const ReplayModel& model, int seeds);

}  // namespace pedzone
