// How far a model is from the recording: what is wanted as one number to be made small.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "validation/calibration.hpp"

namespace pedzone {
namespace {

double squared(double x) { return x * x; }

/// Means of the persons, each as often as `in` says, walked and recorded, each figure over the
/// seeds that have it: where nobody's way crosses a vehicle's in one seed, the others still tell
/// the order.
struct Mean {
  Figures walked{}, recorded{};
  bool any = false;

  double of(Figure f) const { return walked[static_cast<std::size_t>(f)]; }
  /// By how much it is more than recorded.
  double beyond(Figure f) const {
    return std::max(0.0, of(f) - recorded[static_cast<std::size_t>(f)]);
  }
  double off(Figure f) const {
    const double was = recorded[static_cast<std::size_t>(f)];
    return was > 0.0 ? of(f) / was - 1.0 : 0.0;
  }
};

template <class In>
Mean mean_of(const ScoredRuns& runs, const In& in) {
  Mean mean;
  std::array<double, kFigures> seeds{};
  for (const std::vector<ScoredPerson>& run : runs) {
    std::vector<const ScoredPerson*> persons;
    for (const ScoredPerson& person : run) {
      if (person.recorded.clearance >= kInteracting) continue;
      persons.insert(persons.end(), static_cast<std::size_t>(in(person)), &person);
    }
    if (persons.empty()) return mean;
    const Figures walked = figures_of(persons);
    for (std::size_t f = 0; f < kFigures; ++f) {
      if (std::isnan(walked[f])) continue;
      mean.walked[f] += walked[f];
      seeds[f] += 1.0;
    }
    mean.recorded = figures_of(persons, true);
    mean.any = true;
  }
  for (std::size_t f = 0; f < kFigures; ++f) mean.walked[f] /= seeds[f];  // 0/0: not a number
  return mean;
}

/// Tolerances: the targets of whole sites; the share that passes first counts by what is wrong.
double of_site(const Mean& m) {
  double sum =
      squared(m.off(Figure::kClearance) / 0.15) + squared(m.of(Figure::kClearanceKs) / 0.2);
  sum += squared(m.off(Figure::kDeviation) / 0.2) + squared(m.of(Figure::kDeviationKs) / 0.2);
  sum += squared(m.off(Figure::kSpeed) / 0.07) + squared(m.of(Figure::kLeastSpeedKs) / 0.25);
  sum += squared(m.beyond(Figure::kClose) / 0.01);
  sum += squared(m.of(Figure::kAde) / 0.8);
  const double pushed = m.of(Figure::kPushed);
  if (!std::isnan(pushed)) sum += squared(pushed / 0.01);
  const double first = m.of(Figure::kFirst);
  if (!std::isnan(first)) sum += squared((1.0 - first) / 0.08);
  return sum / 10.0;
}

/// Tolerances of one manoeuvre by itself.
double of_manoeuvre(const Mean& m) {
  double sum =
      squared(m.off(Figure::kClearance) / 0.12) + squared(m.of(Figure::kClearanceKs) / 0.3);
  sum += squared(m.off(Figure::kDeviation) / 0.2) + squared(m.of(Figure::kDeviationKs) / 0.3);
  sum += squared(m.of(Figure::kLeastSpeedKs) / 0.45);
  return sum / 5.0;
}

}  // namespace

double misfit(const std::vector<Clip>& clips, const ScoredRuns& runs,
              const std::vector<bool>& used) {
  return misfit(clips, runs, std::vector<int>(used.begin(), used.end()));
}

double misfit(const std::vector<Clip>& clips, const ScoredRuns& runs,
              const std::vector<int>& times) {
  std::set<std::string> sites, manoeuvres;
  for (std::size_t c = 0; c < clips.size(); ++c) {
    if (times[c] == 0) continue;
    sites.insert(clips[c].site);
    manoeuvres.insert(group_of(clips[c]));
  }
  double sum = 0.0, groups = 0.0;
  for (const std::string& site : sites) {
    const Mean mean = mean_of(runs, [&](const ScoredPerson& p) {
      return clips[p.clip].site == site ? times[p.clip] : 0;
    });
    if (!mean.any) continue;
    sum += of_site(mean);
    groups += 1.0;
  }
  for (const std::string& manoeuvre : manoeuvres) {
    const Mean mean = mean_of(runs, [&](const ScoredPerson& p) {
      return group_of(clips[p.clip]) == manoeuvre ? times[p.clip] : 0;
    });
    if (!mean.any) continue;
    // A manoeuvre weighs half a site.
    sum += 0.5 * of_manoeuvre(mean);
    groups += 0.5;
  }
  return groups > 0.0 ? sum / groups : 0.0;
}

}  // namespace pedzone
