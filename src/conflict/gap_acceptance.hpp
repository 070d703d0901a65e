// Which gaps between vehicles people take: a logistic regression.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace pedzone {

/// A gap that somebody took or let pass.
struct GapChoice {
  double gap = 0.0;  ///< [s] until the next vehicle came
  bool taken = false;
};

/// P(taken) = 1 / (1 + exp(-(intercept + slope gap))).
struct GapAcceptance {
  double intercept = 0.0, slope = 0.0;  ///< [-], [1/s]
  double median = 0.0;                  ///< [s] the gap that half of them take: the critical gap
  double low = 0.0, high = 0.0;         ///< [s] its 95 % interval (delta method)
  std::size_t taken = 0, left = 0;      ///< gaps

  /// P(taken) of a gap [s].
  double share(double gap) const;
};

/// Greatest likelihood by Newton's method. Nothing where gaps are too few (under 5 of either kind),
/// or where the longer ones are not the ones that are taken. Where a gap parts all that were taken
/// from all that were not, the fit has no end: that gap is the median, without an interval.
/// Source: Brewer, Fitzpatrick, Whitacre and Lord 2006 fit pedestrians' gaps so.
std::optional<GapAcceptance> fit_gap_acceptance(std::span<const GapChoice> choices);

/// Of the gaps of about a length, how many were taken.
struct GapShare {
  double gap = 0.0;      ///< [s] middle of a whole second
  double share = 0.0;    ///< [0, 1] taken
  std::size_t gaps = 0;  ///< > 0
};

/// [s] assumed: longer ones are all taken, pictures end here.
inline constexpr double kLongestGap = 20.0;

/// By seconds below kLongestGap; those without a gap are left out.
std::vector<GapShare> shares_taken(std::span<const GapChoice> choices);

}  // namespace pedzone
