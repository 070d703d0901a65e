#include "validation/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>

#include "core/error.hpp"
#include "core/random.hpp"
#include "core/statistics.hpp"
#include "crowd/state/parallel.hpp"
#include "validation/evaluation_log.hpp"
#include "validation/tuned_clips.hpp"

namespace pedzone {
namespace {

// T at least 4.5 s: with less, somebody hurries before a car of 2 m/s that then reaches it. m0 at
// most 0.6 m: with more, people turn round before a vehicle that creeps along a lane of 4 m.
constexpr Searched kSearched[] = {
    {"discomfort", 0.7, 6.0, true},     {"discomfortMargin", 0.0, 0.6},
    {"discomfortMarginTime", 0.2, 1.0}, {"discomfortHorizon", 4.5, 5.5},
    {"slowingCost", 0.06, 0.8, true},   {"marginSpread", 0.0, 0.5},
    {"roomBehind", 0.0, 0.8},           {"lettingPass", 0.1, 0.5},
};
constexpr std::size_t kDimensions = std::size(kSearched);
constexpr double kUsualSpeed = 3.0;  // [m/s] of vehicles in shared space
constexpr double kAlike = 0.1;       // [m] finalists whose wanted clearance differs less are alike
constexpr int kMostAlike = 3;
using Point = std::array<double, kDimensions>;  ///< [0, 1] each

/// Generalised golden ratio of that many dimensions (Roberts 2018, "The unreasonable effectiveness
/// of quasirandom sequences"): the root of x^(d+1) = x + 1.
double plastic_number() {
  double x = 1.5;
  for (int i = 0; i < 60; ++i) x = std::pow(1.0 + x, 1.0 / (kDimensions + 1.0));
  return x;
}

/// The n-th point of the additive recurrence with that ratio.
Point sequence_point(int n) {
  static const double ratio = plastic_number();
  Point point;
  for (std::size_t d = 0; d < kDimensions; ++d) {
    const double step = std::pow(1.0 / ratio, static_cast<double>(d + 1));
    point[d] = std::fmod(0.5 + step * (n + 1), 1.0);
  }
  return point;
}

/// Rounded to three digits, so that what is written is what was scored.
double value_of(const Searched& searched, double share) {
  const double value = searched.logarithmic
                           ? searched.least * std::pow(searched.most / searched.least, share)
                           : searched.least + share * (searched.most - searched.least);
  return std::round(value * 1000.0) / 1000.0;
}

Parameters parameters_of(const Point& point) {
  Parameters parameters;
  for (std::size_t d = 0; d < kDimensions; ++d) {
    parameters.*find_parameter(kSearched[d].key)->member = value_of(kSearched[d], point[d]);
  }
  return parameters;
}

/// [m] to a vehicle of a usual speed: what tells the bold from the shy.
double clearance_wanted(const Parameters& parameters) {
  return parameters.discomfort_margin + parameters.discomfort_margin_time * kUsualSpeed;
}

std::vector<Fold> folds_of(const std::vector<Clip>& clips) {
  std::vector<Fold> folds{{"all", std::vector<bool>(clips.size(), true)}};
  const auto leave_out = [&](const std::string& name, auto is_left) {
    Fold fold{"without " + name, {}};
    for (const Clip& clip : clips) fold.tuned.push_back(!is_left(clip));
    // Nothing left to tune on: the only site, or the only manoeuvre.
    if (std::find(fold.tuned.begin(), fold.tuned.end(), true) != fold.tuned.end()) {
      folds.push_back(std::move(fold));
    }
  };
  std::set<std::string> sites, manoeuvres;
  for (const Clip& clip : clips) {
    sites.insert(clip.site);
    manoeuvres.insert(clip.manoeuvre);
  }
  for (const std::string& site : sites) {
    leave_out(site, [&](const Clip& clip) { return clip.site == site; });
  }
  for (const std::string& manoeuvre : manoeuvres) {
    leave_out(manoeuvre, [&](const Clip& clip) { return clip.manoeuvre == manoeuvre; });
  }
  return folds;
}

/// What evaluations are of: other ones count no more. FNV-1a over all places of people and
/// vehicles.
std::string source_of(const std::vector<Clip>& clips, int seeds) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&](std::uint64_t value) { hash = (hash ^ value) * 1099511628211ULL; };
  const auto add_place = [&](const Vec2& place) {
    add(std::bit_cast<std::uint64_t>(place.x()));
    add(std::bit_cast<std::uint64_t>(place.y()));
  };
  for (const Clip& clip : clips) {
    add(person_key(clip.site + "/" + clip.name));
    for (const PersonTrack& person : clip.persons) {
      add(static_cast<std::uint64_t>(person.first));
      for (const Vec2& place : person.places) add_place(place);
    }
    for (const VehicleTrack& vehicle : clip.vehicles) {
      add(static_cast<std::uint64_t>(vehicle.first));
      for (const VehicleState& state : vehicle.states) {
        add_place(state.centre);
        add_place({state.length, state.width});
      }
    }
  }
  return fmt::format("{} clips ({:016x}), {} seeds", clips.size(), hash, seeds);
}

ReplayModel model_of(const Parameters& parameters) {
  ReplayModel model;
  model.name = "calibrated";
  model.parameters = parameters;
  return model;
}

/// All that a search needs.
class Search {
 public:
  Search(const std::vector<Clip>& clips, const CalibrationOptions& options,
         const Progressed& progressed)
      : clips_(clips),
        options_(options),
        progressed_(progressed),
        folds_(folds_of(clips)),
        log_(options.log, source_of(clips, options.seeds), column_names(), folds_.size()) {
    total_ = options.first + static_cast<int>(folds_.size()) * options.rounds * options.points +
             options.finalists;
  }

  CalibrationResult run() {
    CalibrationResult result;
    std::vector<std::pair<Point, std::vector<double>>> shared;
    for (int n = 0; n < options_.first; ++n) {
      const Point point = sequence_point(n);
      shared.emplace_back(point, misfits(point));
    }
    for (std::size_t f = 0; f < folds_.size(); ++f) {
      std::vector<std::pair<double, Point>> found;
      for (const auto& [point, misfit_of] : shared) found.emplace_back(misfit_of[f], point);
      refine(f, found);
      std::stable_sort(found.begin(), found.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      if (f == 0) result.finalists = finalists_of(found);
      result.folds.push_back(f == 0 ? fold_result(0, chosen_of(result.finalists))
                                    : fold_result(f, found.front()));
    }
    result.evaluations = evaluations_;
    result.reused = reused_;
    return result;
  }

 private:
  std::vector<std::string> column_names() const {
    std::vector<std::string> names;
    for (const Searched& searched : kSearched) names.emplace_back(searched.key);
    for (const Fold& fold : folds_) names.push_back(fold.name);
    return names;
  }

  /// Of every fold, from the log where it has the point already.
  std::vector<double> misfits(const Point& point) {
    const Parameters parameters = parameters_of(point);
    std::vector<double> values;
    for (const Searched& searched : kSearched) {
      values.push_back(parameters.*find_parameter(searched.key)->member);
    }
    std::vector<double> known = log_.find(values);
    ++evaluations_;
    if (known.empty()) {
      const ScoredRuns runs = score(clips_, model_of(parameters), options_.seeds);
      for (const Fold& fold : folds_) known.push_back(misfit(clips_, runs, fold.tuned));
      log_.append(values, known);
      own_.insert(values);
    } else if (!own_.contains(values)) {
      ++reused_;
    }
    progressed_(std::min(1.0, static_cast<double>(evaluations_) / total_));
    return known;
  }

  /// Rounds in boxes about the best so far, half as wide each time.
  void refine(std::size_t fold, std::vector<std::pair<double, Point>>& found) {
    double width = 0.5;
    for (int round = 0; round < options_.rounds; ++round, width *= 0.5) {
      const Point best =
          std::min_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
            return a.first < b.first;
          })->second;
      for (int n = 0; n < options_.points; ++n) {
        const Point unit = sequence_point(options_.first + round * options_.points + n);
        Point point;
        for (std::size_t d = 0; d < kDimensions; ++d) {
          point[d] = std::clamp(best[d] + width * (unit[d] - 0.5), 0.0, 1.0);
        }
        found.emplace_back(misfits(point)[fold], point);
      }
    }
  }

  /// The best points, but no more than three that keep about the same clearance; scored with seeds
  /// that the search did not use: the least of many noisy figures is not the figure of the best.
  std::vector<Finalist> finalists_of(const std::vector<std::pair<double, Point>>& found) {
    std::map<int, int> alike;
    std::vector<Finalist> finalists;
    std::vector<ScoredRuns> scored;
    for (const auto& [searched_misfit, point] : found) {
      if (static_cast<int>(finalists.size()) == options_.finalists) break;
      Finalist finalist;
      finalist.parameters = parameters_of(point);
      const double shyness = clearance_wanted(finalist.parameters);
      if (++alike[static_cast<int>(std::floor(shyness / kAlike))] > kMostAlike) continue;
      ScoredRuns runs = score(clips_, model_of(finalist.parameters), 3 * options_.seeds);
      runs.erase(runs.begin(), runs.begin() + options_.seeds);
      finalist.misfit = misfit(clips_, runs, folds_[0].tuned);
      finalists.push_back(finalist);
      scored.push_back(std::move(runs));
      ++evaluations_;
      progressed_(std::min(1.0, static_cast<double>(evaluations_) / total_));
    }
    find_valley(scored, finalists);
    return finalists;
  }

  /// How far each is from the best of them, in the fold in which it is farthest.
  void find_regrets(const std::vector<ScoredRuns>& scored, std::vector<Finalist>& finalists) const {
    for (const Fold& fold : folds_) {
      std::vector<double> misfits;
      for (const ScoredRuns& runs : scored) misfits.push_back(misfit(clips_, runs, fold.tuned));
      const double least = *std::ranges::min_element(misfits);
      for (std::size_t i = 0; i < finalists.size(); ++i) {
        finalists[i].regret = std::max(finalists[i].regret, misfits[i] - least);
      }
    }
  }

  /// Sorts by misfit and tells which are within noise of the best.
  void find_valley(const std::vector<ScoredRuns>& scored, std::vector<Finalist>& finalists) const {
    find_regrets(scored, finalists);
    std::vector<std::vector<double>> resampled(finalists.size());
    for_each_parallel(finalists.size(), [&](std::size_t i) {
      for (int r = 1; r <= options_.resamples; ++r) {
        resampled[i].push_back(misfit(clips_, scored[i], drawn_clips(r)));
      }
    });
    std::size_t best = 0;
    for (std::size_t i = 1; i < finalists.size(); ++i) {
      if (finalists[i].misfit < finalists[best].misfit) best = i;
    }
    for (std::size_t i = 0; i < finalists.size(); ++i) {
      std::vector<double> more;
      for (std::size_t r = 0; r < resampled[i].size(); ++r) {
        more.push_back(resampled[i][r] - resampled[best][r]);
      }
      finalists[i].error = standard_deviation(more, mean(more));
      finalists[i].in_valley = finalists[i].misfit - finalists[best].misfit <= finalists[i].error;
    }
    std::stable_sort(finalists.begin(), finalists.end(),
                     [](const Finalist& a, const Finalist& b) { return a.misfit < b.misfit; });
    Finalist* chosen = &finalists.front();
    for (Finalist& finalist : finalists) {
      if (finalist.in_valley && finalist.regret < chosen->regret) chosen = &finalist;
    }
    chosen->chosen = true;
  }

  /// How often each clip is drawn: as many as there are of each site and manoeuvre, from these.
  std::vector<int> drawn_clips(int resample) const {
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t c = 0; c < clips_.size(); ++c) groups[group_of(clips_[c])].push_back(c);
    std::vector<int> times(clips_.size());
    for (const auto& [group, members] : groups) {
      for (std::size_t k = 0; k < members.size(); ++k) {
        const double share = random_uniform(static_cast<std::uint64_t>(resample), person_key(group),
                                            k, Purpose::kBootstrap);
        const auto drawn = static_cast<std::size_t>(share * static_cast<double>(members.size()));
        ++times[members[std::min(drawn, members.size() - 1)]];
      }
    }
    return times;
  }

  static std::pair<double, Parameters> chosen_of(const std::vector<Finalist>& finalists) {
    const auto chosen = std::ranges::find(finalists, true, &Finalist::chosen);
    return {chosen->misfit, chosen->parameters};
  }

  FoldResult fold_result(std::size_t f, const std::pair<double, Point>& best) {
    return fold_result(f, std::pair{best.first, parameters_of(best.second)});
  }

  FoldResult fold_result(std::size_t f, const std::pair<double, Parameters>& best) {
    FoldResult result;
    result.fold = folds_[f];
    result.parameters = best.second;
    result.misfit = best.first;
    std::vector<Clip> rest;
    for (std::size_t c = 0; c < clips_.size(); ++c) {
      if (f == 0 || !folds_[f].tuned[c]) rest.push_back(clips_[c]);
    }
    ValidationOptions options;
    options.models = {model_of(result.parameters)};
    options.seeds = options_.seeds;
    options.references = false;
    for (ValidationRow& row : validate(std::move(rest), options, [](double) {}).rows) {
      if (row.set == PersonSet::kRecorded) result.rows.push_back(std::move(row));
    }
    return result;
  }

  const std::vector<Clip>& clips_;
  CalibrationOptions options_;
  const Progressed& progressed_;
  std::vector<Fold> folds_;
  EvaluationLog log_;
  std::set<std::vector<double>> own_;  ///< scored now, and not known from before
  int evaluations_ = 0, reused_ = 0, total_ = 1;
};

}  // namespace

std::span<const Searched> searched_parameters() { return kSearched; }

CalibrationResult calibrate(const std::vector<Clip>& clips, const CalibrationOptions& options,
                            const Progressed& progressed) {
  std::vector<Clip> useful;
  for (const Clip& clip : clips) {
    if (!clip.vehicles.empty()) useful.push_back(clip);
  }
  if (useful.size() < 2) {
    throw InputError("are too few clips with vehicles to cross-validate with",
                     {"", 0, "option --data", std::to_string(useful.size()), "two or more"});
  }
  if (const std::size_t scored = scored_clips(useful).size(); scored < 2) {
    throw InputError(
        "have too few clips in which somebody comes within 3 m of a vehicle that moves: there is "
        "nothing to tune on",
        {"", 0, "option --data", std::to_string(scored),
         "two or more; coordinates in m, headings in rad, counter-clockwise from +x"});
  }
  return Search(useful, options, progressed).run();
}

}  // namespace pedzone
