// What the end of the runs cuts off: who is still under way then has no whole travel time.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "study/compare/results.hpp"

namespace pedzone::study {
namespace {

constexpr double kApart = 0.05;  // assumed: shares arrived that differ by more are no fair pair
constexpr double kFew = 0.8;     // assumed: nor are such small ones, even where they are alike

/// Times that grow while somebody is under way, and the share that has arrived.
struct CutTime {
  std::string_view measure, arrived;
};
constexpr CutTime kTimes[] = {
    {"person.travelTime", "person.arrived"},   {"person.travelTime85", "person.arrived"},
    {"person.travelTime95", "person.arrived"}, {"person.delay85", "person.arrived"},
    {"person.delay95", "person.arrived"},      {"person.delay", "person.arrived"},
    {"person.waiting", "person.arrived"},      {"vehicle.travelTime", "vehicle.arrived"},
    {"vehicle.delay", "vehicle.arrived"}};

const Comparison* find(std::span<const Comparison> of_model, std::string_view measure) {
  const auto found = std::ranges::find(of_model, measure, &Comparison::measure);
  return found == of_model.end() ? nullptr : &*found;
}

bool are_apart(const Comparison& shares) { return std::abs(shares.difference.mean) > kApart; }

/// The comparison of shares arrived where they are apart, or small; null where they are not, or not
/// known.
const Comparison* cut_short(std::span<const Comparison> of_model, std::string_view arrived) {
  const Comparison* const shares = find(of_model, arrived);
  if (shares == nullptr || shares->difference.n == 0) return nullptr;
  const bool few = std::min(*shares->reference.mean, *shares->sample.mean) < kFew;
  return few || are_apart(*shares) ? shares : nullptr;
}

}  // namespace

void mark_cut_off(std::span<Comparison> of_model) {
  for (const CutTime& cut : kTimes) {
    const auto time = std::ranges::find(of_model, cut.measure, &Comparison::measure);
    const Comparison* const arrived = cut_short(of_model, cut.arrived);
    if (time == of_model.end() || arrived == nullptr) continue;
    // Who has fewer arrivals has the times that are too short. Where they are the longer ones all
    // the same, the difference is at least that.
    const bool longer_cut = (arrived->difference.mean < 0.0) == (time->difference.mean > 0.0);
    time->bound = are_apart(*arrived) && longer_cut ? Bound::kAtLeast : Bound::kUnknown;
  }
}

std::optional<CutOff> cut_off(std::span<const Comparison> of_model) {
  const Comparison* const arrived = cut_short(of_model, "person.arrived");
  if (arrived == nullptr) return {};
  CutOff cut{*arrived->reference.mean, *arrived->sample.mean, are_apart(*arrived), {}};
  const Comparison* const nearly = find(of_model, "person.nearlyAll");
  if (nearly == nullptr || nearly->undefined > 0 || nearly->difference.n == 0) return cut;
  constexpr double kRound = 100.0;  // [s]
  const double latest = std::max(*nearly->reference.max, *nearly->sample.max);
  cut.end = kRound * std::ceil(latest / kRound);
  return cut;
}

}  // namespace pedzone::study
