#include "conflict/gap_acceptance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pedzone {
namespace {

constexpr std::size_t kLeast = 5;     // assumed: fewer of a kind tell nothing
constexpr int kSteps = 100;           // numerical: Newton's method takes less than ten
constexpr double kConverged = 1e-10;  // numerical
constexpr double kQuantile = 1.959963984540054;  // of the normal distribution, 97.5 %

/// The log likelihood's gradient and (negative) second derivatives.
struct Derivatives {
  double g0 = 0.0, g1 = 0.0, h00 = 0.0, h01 = 0.0, h11 = 0.0;
};

Derivatives derivatives(std::span<const GapChoice> choices, const GapAcceptance& fit) {
  Derivatives d;
  for (const GapChoice& choice : choices) {
    const double p = fit.share(choice.gap);
    const double rest = (choice.taken ? 1.0 : 0.0) - p, weight = p * (1.0 - p);
    d.g0 += rest;
    d.g1 += rest * choice.gap;
    d.h00 += weight;
    d.h01 += weight * choice.gap;
    d.h11 += weight * choice.gap * choice.gap;
  }
  return d;
}

/// The gap between the longest that was left and the shortest that was taken, if that parts them.
std::optional<double> parting_gap(std::span<const GapChoice> choices) {
  double longest_left = 0.0, shortest_taken = std::numeric_limits<double>::infinity();
  for (const GapChoice& choice : choices) {
    if (choice.taken) shortest_taken = std::min(shortest_taken, choice.gap);
    if (!choice.taken) longest_left = std::max(longest_left, choice.gap);
  }
  if (longest_left > shortest_taken) return std::nullopt;
  return 0.5 * (longest_left + shortest_taken);
}

}  // namespace

double GapAcceptance::share(double gap) const {
  return 1.0 / (1.0 + std::exp(-(intercept + slope * gap)));
}

std::optional<GapAcceptance> fit_gap_acceptance(std::span<const GapChoice> choices) {
  GapAcceptance fit;
  fit.taken = static_cast<std::size_t>(std::ranges::count(choices, true, &GapChoice::taken));
  fit.left = choices.size() - fit.taken;
  if (fit.taken < kLeast || fit.left < kLeast) return std::nullopt;
  if (const auto gap = parting_gap(choices)) {
    fit.median = fit.low = fit.high = *gap;
    fit.slope = std::numeric_limits<double>::infinity();
    return fit;
  }
  Derivatives d;
  for (int step = 0; step < kSteps; ++step) {
    d = derivatives(choices, fit);
    const double determinant = d.h00 * d.h11 - d.h01 * d.h01;
    if (!(determinant > 0.0)) return std::nullopt;
    const double by0 = (d.h11 * d.g0 - d.h01 * d.g1) / determinant;
    const double by1 = (d.h00 * d.g1 - d.h01 * d.g0) / determinant;
    fit.intercept += by0;
    fit.slope += by1;
    if (std::abs(by0) + std::abs(by1) < kConverged) break;
  }
  if (!(fit.slope > 0.0)) return std::nullopt;
  fit.median = -fit.intercept / fit.slope;
  // The variance of -a/b by the covariance of a and b, the inverse of the second derivatives.
  const double determinant = d.h00 * d.h11 - d.h01 * d.h01;
  const double to0 = -1.0 / fit.slope, to1 = fit.intercept / (fit.slope * fit.slope);
  const double variance =
      (to0 * to0 * d.h11 - 2.0 * to0 * to1 * d.h01 + to1 * to1 * d.h00) / determinant;
  const double half = kQuantile * std::sqrt(std::max(0.0, variance));
  fit.low = fit.median - half;
  fit.high = fit.median + half;
  return fit;
}

std::vector<GapShare> shares_taken(std::span<const GapChoice> choices) {
  std::array<std::size_t, static_cast<std::size_t>(kLongestGap)> taken{}, all{};
  for (const GapChoice& choice : choices) {
    if (choice.gap < 0.0 || choice.gap >= kLongestGap) continue;
    const auto second = static_cast<std::size_t>(choice.gap);
    ++all[second];
    if (choice.taken) ++taken[second];
  }
  std::vector<GapShare> shares;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k] == 0) continue;
    const double share = static_cast<double>(taken[k]) / static_cast<double>(all[k]);
    shares.push_back({static_cast<double>(k) + 0.5, share, all[k]});
  }
  return shares;
}

}  // namespace pedzone
