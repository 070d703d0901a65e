// What the end of the runs cuts off: who is still under way then has no whole travel time.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "study/compare/results.hpp"

namespace pedzone::study {
namespace {

constexpr double kApart = 0.05;  // assumed: shares arrived that differ by more are no fair pair

/// Times that grow while somebody is under way, and the share that has arrived.
struct CutTime {
  std::string_view measure, arrived;
};
constexpr CutTime kTimes[] = {{"person.travelTime", "person.arrived"},
                              {"person.delay", "person.arrived"},
                              {"person.waiting", "person.arrived"},
                              {"vehicle.travelTime", "vehicle.arrived"},
                              {"vehicle.delay", "vehicle.arrived"}};

const Comparison* find(std::span<const Comparison> of_model, std::string_view measure) {
  const auto found = std::ranges::find(of_model, measure, &Comparison::measure);
  return found == of_model.end() ? nullptr : &*found;
}

}  // namespace

void mark_cut_off(std::span<Comparison> of_model) {
  for (const CutTime& cut : kTimes) {
    const auto time = std::ranges::find(of_model, cut.measure, &Comparison::measure);
    const Comparison* const arrived = find(of_model, cut.arrived);
    if (time == of_model.end() || arrived == nullptr || arrived->difference.n == 0) continue;
    const double more = arrived->difference.mean;
    if (std::abs(more) <= kApart) continue;
    // Who has fewer arrivals has the times that are too short. Where they are the longer ones all
    // the same, the difference is at least that.
    const bool longer_cut = (more < 0.0) == (time->difference.mean > 0.0);
    time->bound = longer_cut ? Bound::kAtLeast : Bound::kUnknown;
  }
}

std::optional<CutOff> cut_off(std::span<const Comparison> of_model) {
  const Comparison* const arrived = find(of_model, "person.arrived");
  if (arrived == nullptr || arrived->difference.n == 0 ||
      std::abs(arrived->difference.mean) <= kApart) {
    return {};
  }
  CutOff cut{*arrived->reference.mean, *arrived->sample.mean, {}};
  const Comparison* const nearly = find(of_model, "person.nearlyAll");
  if (nearly == nullptr || nearly->undefined > 0 || nearly->difference.n == 0) return cut;
  constexpr double kRound = 100.0;  // [s]
  const double latest = std::max(*nearly->reference.max, *nearly->sample.max);
  cut.end = kRound * std::ceil(latest / kRound);
  return cut;
}

}  // namespace pedzone::study
