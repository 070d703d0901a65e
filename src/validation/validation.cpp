#include "validation/validation.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/random.hpp"
#include "core/statistics.hpp"
#include "crowd/state/parallel.hpp"

namespace pedzone {
namespace {

constexpr std::uint64_t kBootstrapSeed = 20190101;  // numerical: any

bool in_group(const Clip& clip, const std::string& group) {
  return group == "all" || group == clip.site || group == group_of(clip);
}

/// Least clearance of each scored person when it walks straight at its own speed, without jitter.
using Straight = std::map<std::pair<std::uint32_t, std::uint32_t>, double>;

std::vector<ReplayModel> reference_models() {
  ReplayModel straight, constant, plain;
  straight.name = "straight to goal";
  straight.kind = ReplayModel::Kind::kStraight;
  constant.name = "constant velocity";
  constant.kind = ReplayModel::Kind::kConstantVelocity;
  plain.name = plain.model = "plain";
  return {straight, constant, plain};
}

/// Persons of all seeds of one set and group, by clip.
struct ByClip {
  std::vector<std::vector<std::vector<const ScoredPerson*>>> persons;  ///< [clip][seed]
  std::size_t count = 0;
};

ByClip by_clip(const ValidationResult& result, const ScoredRuns& runs, PersonSet set,
               const std::string& group) {
  std::map<std::uint32_t, std::vector<std::vector<const ScoredPerson*>>> found;
  ByClip sorted;
  for (std::size_t seed = 0; seed < runs.size(); ++seed) {
    for (const ScoredPerson* person : members(result, runs, seed, set, group)) {
      auto& clip = found[person->clip];
      clip.resize(runs.size());
      clip[seed].push_back(person);
      if (seed == 0) ++sorted.count;
    }
  }
  for (auto& [clip, persons] : found) sorted.persons.push_back(std::move(persons));
  return sorted;
}

/// Mean over seeds, or their greatest, for the clips of `chosen` (indices into sample.persons,
/// repeats allowed).
Figures mean_figures(const ByClip& sample, const std::vector<std::size_t>& chosen, bool recorded) {
  const std::size_t seeds = recorded ? 1 : sample.persons.front().size();
  Figures sum{};
  std::array<int, kFigures> numbers{};
  std::vector<const ScoredPerson*> persons;
  for (std::size_t seed = 0; seed < seeds; ++seed) {
    persons.clear();
    for (const std::size_t clip : chosen) {
      const auto& more = sample.persons[clip][seed];
      persons.insert(persons.end(), more.begin(), more.end());
    }
    const Figures one = figures_of(persons, recorded);
    for (std::size_t f = 0; f < kFigures; ++f) {
      if (std::isnan(one[f])) continue;
      const bool greatest = figure_list()[f].kind == FigureInfo::Kind::kGreatest;
      sum[f] = greatest ? std::max(sum[f], one[f]) : sum[f] + one[f];
      ++numbers[f];
    }
  }
  for (std::size_t f = 0; f < kFigures; ++f) {
    const bool greatest = figure_list()[f].kind == FigureInfo::Kind::kGreatest;
    if (!greatest || numbers[f] == 0) sum[f] /= numbers[f];  // none: not a number
  }
  return sum;
}

/// Which figures have an interval: not what fewer than kLeastClips tell of.
std::array<bool, kFigures> have_interval(const ByClip& sample, bool recorded) {
  std::array<std::size_t, kFigures> clips{};
  for (std::size_t c = 0; c < sample.persons.size(); ++c) {
    const Figures one = mean_figures(sample, {c}, recorded);
    for (std::size_t f = 0; f < kFigures; ++f) clips[f] += std::isnan(one[f]) ? 0 : 1;
  }
  std::array<bool, kFigures> have{};
  for (std::size_t f = 0; f < kFigures; ++f) {
    have[f] = figure_list()[f].has_interval() && clips[f] >= kLeastClips;
  }
  return have;
}

void fill_row(const ByClip& sample, bool recorded, int resamples, ValidationRow& row) {
  const std::size_t clips = sample.persons.size();
  std::vector<std::size_t> chosen(clips);
  for (std::size_t i = 0; i < clips; ++i) chosen[i] = i;
  row.persons = sample.count;
  row.clips = clips;
  row.value = mean_figures(sample, chosen, recorded);
  row.low.fill(std::numeric_limits<double>::quiet_NaN());
  row.high = row.low;
  if (clips < kLeastClips) return;
  const auto have = have_interval(sample, recorded);
  std::vector<std::vector<double>> spread(kFigures);
  for (int r = 0; r < resamples; ++r) {
    for (std::size_t i = 0; i < clips; ++i) {
      const double u =
          random_uniform(kBootstrapSeed, static_cast<std::uint64_t>(r), i, Purpose::kBootstrap);
      chosen[i] = static_cast<std::size_t>(u * static_cast<double>(clips));
    }
    const Figures one = mean_figures(sample, chosen, recorded);
    for (std::size_t f = 0; f < kFigures; ++f) {
      if (!std::isnan(one[f]) && have[f]) spread[f].push_back(one[f]);
    }
  }
  for (std::size_t f = 0; f < kFigures; ++f) {
    if (!have[f]) continue;
    row.low[f] = quantile(spread[f], 0.025);
    row.high[f] = quantile(spread[f], 0.975);
  }
}

struct RowTask {
  ValidationRow row;
  ByClip sample;
  bool recorded = false;
};

std::vector<RowTask> row_tasks(const ValidationResult& result) {
  std::vector<RowTask> tasks;
  for (const PersonSet set : {PersonSet::kRecorded, PersonSet::kStraight}) {
    for (const std::string& group : groups_of(result.data)) {
      for (std::size_t m = 0; m <= result.models.size(); ++m) {
        RowTask task;
        task.recorded = m == 0;
        const ScoredRuns& runs = result.runs[m == 0 ? 0 : m - 1];
        task.sample = by_clip(result, runs, set, group);
        if (task.sample.persons.empty()) continue;
        task.row.set = set;
        task.row.group = group;
        task.row.model = m == 0 ? "recorded" : result.models[m - 1];
        tasks.push_back(std::move(task));
      }
    }
  }
  return tasks;
}

}  // namespace

const char* name_of(PersonSet set) { return set == PersonSet::kRecorded ? "recorded" : "straight"; }

std::vector<std::string> groups_of(const std::vector<Clip>& clips) {
  std::set<std::string> sites, manoeuvres;
  for (const Clip& clip : clips) {
    sites.insert(clip.site);
    if (!clip.vehicles.empty()) manoeuvres.insert(group_of(clip));
  }
  std::vector<std::string> groups;
  if (sites.size() > 1) groups.push_back("all");
  groups.insert(groups.end(), sites.begin(), sites.end());
  groups.insert(groups.end(), manoeuvres.begin(), manoeuvres.end());
  return groups;
}

std::vector<const ScoredPerson*> members(const ValidationResult& result, const ScoredRuns& runs,
                                         std::size_t seed, PersonSet set,
                                         const std::string& group) {
  std::vector<const ScoredPerson*> found;
  for (const ScoredPerson& person : runs[seed]) {
    if (!in_group(result.data[person.clip], group)) continue;
    const double clearance =
        set == PersonSet::kRecorded ? person.recorded.clearance : person.straight_clearance;
    if (clearance < kInteracting) found.push_back(&person);
  }
  return found;
}

ValidationResult validate(std::vector<Clip> clips, const ValidationOptions& options,
                          const Progressed& progressed) {
  ValidationResult result;
  result.data = std::move(clips);
  result.clips = result.data.size();
  result.seeds = options.seeds;
  for (const Clip& clip : result.data) result.persons += clip.persons.size();
  std::vector<ReplayModel> models;
  if (options.references) models = reference_models();
  models.insert(models.end(), options.models.begin(), options.models.end());
  for (std::size_t m = 0; m < models.size(); ++m) {
    result.models.push_back(models[m].name);
    result.runs.push_back(score(result.data, models[m], options.seeds));
    progressed(0.5 * static_cast<double>(m + 1) / static_cast<double>(models.size()));
  }
  result.scored = result.runs.front().front().size();
  std::vector<RowTask> tasks = row_tasks(result);
  std::atomic<std::size_t> done = 0;
  for_each_parallel(tasks.size(), [&](std::size_t k) {
    fill_row(tasks[k].sample, tasks[k].recorded, options.resamples, tasks[k].row);
    progressed(0.5 + 0.5 * static_cast<double>(++done) / static_cast<double>(tasks.size()));
  });
  for (RowTask& task : tasks) result.rows.push_back(std::move(task.row));
  return result;
}

std::vector<DrawnCase> worst_cases(const ValidationResult& result, const ReplayModel& model,
                                   std::size_t count) {
  const auto found = std::find(result.models.begin(), result.models.end(), model.name);
  const ScoredRuns& runs = result.runs[static_cast<std::size_t>(found - result.models.begin())];
  auto persons = members(result, runs, 0, PersonSet::kRecorded, "all");
  std::stable_sort(persons.begin(), persons.end(),
                   [](const auto* a, const auto* b) { return a->walked.ade > b->walked.ade; });
  std::set<std::uint32_t> seen;
  std::vector<DrawnCase> cases;
  for (const ScoredPerson* person : persons) {
    if (cases.size() >= count || !seen.insert(person->clip).second) continue;
    const Clip& clip = result.data[person->clip];
    const PersonTrack& track = clip.persons[person->person];
    DrawnCase drawn{model.name,
                    clip.name,
                    track.id,
                    group_of(clip),
                    track.first,
                    track.places,
                    replay(clip, model, 1).ways[person->person],
                    {},
                    person->recorded,
                    person->walked};
    const VehicleTrack* nearest = nullptr;
    double least = 1e9;
    for (const VehicleTrack& vehicle : clip.vehicles) {
      for (int frame = track.first; frame <= track.last(); ++frame) {
        const VehicleState* state = at_frame(vehicle, frame);
        if (state == nullptr || state->velocity.norm() < kMovingSpeed) continue;
        const auto at = static_cast<std::size_t>(frame - track.first);
        const double clearance = signed_clearance(*state, track.places[at]);
        if (clearance < least) nearest = &vehicle;
        least = std::min(least, clearance);
      }
    }
    for (int frame = track.first; nearest != nullptr && frame <= track.last(); ++frame) {
      if (const VehicleState* state = at_frame(*nearest, frame)) {
        drawn.vehicle.emplace_back(frame, *state);
      }
    }
    cases.push_back(std::move(drawn));
  }
  return cases;
}

}  // namespace pedzone
