#include "validation/scores.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/statistics.hpp"
#include "crowd/state/parallel.hpp"

namespace pedzone {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr int kLeastFrames = 30;                     // 3 s
constexpr double kLeastWay = 2.0;                    // [m]
constexpr double kClose = 0.25;                      // [m]
constexpr double kPetCounts = 5.0, kPetClose = 2.0;  // [s]

/// Of those whose recorded way crosses that of a vehicle with |PET| ≤ `limit`.
struct Crossings {
  int all = 0;     ///< recorded
  int walked = 0;  ///< the walked way crosses one, too
  int right = 0;   ///< and the person is first or second as recorded

  Crossings(std::span<const ScoredPerson* const> persons, double limit) {
    for (const ScoredPerson* p : persons) {
      const auto &recorded = p->recorded.passing, &again = p->walked.passing;
      if (!recorded || recorded->gap > limit) continue;
      ++all;
      if (!again) continue;
      ++walked;
      if (recorded->person_first == again->person_first) ++right;
    }
  }
  double right_of(int number) const {
    return number > 0 ? static_cast<double>(right) / number : kNothing;
  }
};

template <class Get>
std::vector<double> column(std::span<const ScoredPerson* const> persons, bool recorded, Get get) {
  std::vector<double> values;
  values.reserve(persons.size());
  for (const ScoredPerson* p : persons) values.push_back(get(recorded ? p->recorded : p->walked));
  return values;
}

/// Nothing where no crowd walked them.
void set_pushes(std::span<const ScoredPerson* const> persons, Figures& f) {
  std::vector<double> pushed, hit;
  double way = 0.0, speed = 0.0;
  for (const ScoredPerson* p : persons) {
    if (!p->walked.push) return;
    const PushedPerson& push = *p->walked.push;
    pushed.push_back(push.way > 0.0 || push.run_into ? 1.0 : 0.0);
    hit.push_back(push.run_into ? 1.0 : 0.0);
    way = std::max(way, push.way);
    speed = std::max(speed, push.speed);
  }
  f[static_cast<std::size_t>(Figure::kPushed)] = mean(pushed);
  f[static_cast<std::size_t>(Figure::kPushWay)] = way;
  f[static_cast<std::size_t>(Figure::kPushSpeed)] = speed;
  f[static_cast<std::size_t>(Figure::kRunInto)] = mean(hit);
}

}  // namespace

const std::array<FigureInfo, kFigures>& figure_list() {
  using Kind = FigureInfo::Kind;
  static constexpr std::array<FigureInfo, kFigures> kList{{
      {"inside", "inside", "%",
       "persons whose centre enters a moving vehicle's rectangle, where vehicles push nobody", 100,
       1},
      {"close", "<0.25", "%",
       "persons whose centre comes within 0.25 m of it, where vehicles push nobody", 100, 1},
      {"pushed", "pushed", "%", "persons whom a moving vehicle pushes by 1 cm or more", 100, 1},
      {"push_way", "far", "m", "longest way that one is pushed", 1, 2, Kind::kGreatest},
      {"push_speed", "fast", "m/s", "greatest speed of it (3 at most)", 1, 2, Kind::kGreatest},
      {"run_into", "hit", "%",
       "persons run into: pushed along by over 1 m, or they would have to be pushed faster, or "
       "cannot be",
       100, 1},
      {"clearance", "clear", "m", "smallest clearance of the centre to it, median", 1, 2},
      {"clearance_p5", "p5", "m", "the same, 5th percentile", 1, 2},
      {"clearance_ks", "K-S", "", "Kolmogorov-Smirnov distance of it to the recording", 1, 2},
      {"deviation", "dev", "m", "greatest distance from the start-goal line, median", 1, 2},
      {"deviation_ks", "K-S", "", "Kolmogorov-Smirnov distance of it to the recording", 1, 2},
      {"speed", "speed", "m/s", "mean speed until 0.5 m before the goal, mean", 1, 2},
      {"least_speed", "least", "m/s", "least speed over 0.5 s until then, median", 1, 2},
      {"least_speed_ks", "K-S", "", "Kolmogorov-Smirnov distance of it to the recording", 1, 2},
      {"first", "first5", "%", "first or second as recorded, where recorded PET <= 5 s", 100, 1},
      {"first_count", "n5", "", "of so many: recorded PET <= 5 s, and crossing in the replay, too",
       1, 0, Kind::kCount},
      {"first_of_all", "all5", "%", "first5 if who no longer crosses in the replay counts as wrong",
       100, 1},
      {"first_close", "first2", "%", "as first5, where recorded PET <= 2 s", 100, 1},
      {"first_close_count", "n2", "", "of so many: as n5, where recorded PET <= 2 s", 1, 0,
       Kind::kCount},
      {"first_close_of_all", "all2", "%", "as all5, where recorded PET <= 2 s", 100, 1},
      {"pet", "PET", "s", "post-encroachment time, size, median", 1, 1},
      {"ttc", "TTC", "s", "least time to collision, median", 1, 1},
      {"ade", "ADE", "m", "mean distance to the recorded person, mean", 1, 2},
      {"fde", "FDE", "m", "distance to it at the end, mean", 1, 2},
  }};
  return kList;
}

Figures figures_of(std::span<const ScoredPerson* const> persons, bool recorded) {
  Figures f;
  f.fill(kNothing);
  if (persons.empty()) return f;
  const auto set = [&](Figure figure, double value) {
    f[static_cast<std::size_t>(figure)] = value;
  };
  const auto of = [&](auto get) { return column(persons, recorded, get); };
  const auto ks = [&](auto get) {
    return recorded ? kNothing
                    : ks_distance(column(persons, true, get), column(persons, false, get));
  };
  const auto clearance = [](const Measures& m) { return m.clearance; };
  const auto deviation = [](const Measures& m) { return m.deviation; };
  const auto least_speed = [](const Measures& m) { return m.least_speed; };
  set(Figure::kInside, mean(of([](const Measures& m) { return m.unpushed < 0.0 ? 1.0 : 0.0; })));
  set(Figure::kClose, mean(of([](const Measures& m) { return m.unpushed < kClose ? 1.0 : 0.0; })));
  set(Figure::kClearance, median(of(clearance)));
  set(Figure::kClearanceLow, quantile(of(clearance), 0.05));
  set(Figure::kClearanceKs, ks(clearance));
  set(Figure::kDeviation, median(of(deviation)));
  set(Figure::kDeviationKs, ks(deviation));
  set(Figure::kSpeed, mean(of([](const Measures& m) { return m.mean_speed; })));
  set(Figure::kLeastSpeed, median(of(least_speed)));
  set(Figure::kLeastSpeedKs, ks(least_speed));
  const Crossings crossings(persons, kPetCounts), close(persons, kPetClose);
  set(Figure::kFirstCount, recorded ? crossings.all : crossings.walked);
  set(Figure::kFirstCloseCount, recorded ? close.all : close.walked);
  if (!recorded) {
    set_pushes(persons, f);
    set(Figure::kFirst, crossings.right_of(crossings.walked));
    set(Figure::kFirstOfAll, crossings.right_of(crossings.all));
    set(Figure::kFirstClose, close.right_of(close.walked));
    set(Figure::kFirstCloseOfAll, close.right_of(close.all));
    set(Figure::kAde, mean(of([](const Measures& m) { return m.ade; })));
    set(Figure::kFde, mean(of([](const Measures& m) { return m.fde; })));
  }
  std::vector<double> pet;
  for (const ScoredPerson* p : persons) {
    const Measures& m = recorded ? p->recorded : p->walked;
    if (m.passing) pet.push_back(m.passing->gap);
  }
  set(Figure::kPet, median(pet));
  set(Figure::kTtc, median(of([](const Measures& m) { return m.least_ttc; })));
  return f;
}

bool counts(const PersonTrack& track) {
  return static_cast<int>(track.places.size()) > kLeastFrames &&
         (track.places.back() - track.places.front()).norm() >= kLeastWay;
}

/// What does not depend on the model: recorded measures, and the clearance of straight walking.
static std::vector<ScoredPerson> recorded_persons(const std::vector<Clip>& clips, std::size_t c) {
  ReplayModel straight;
  straight.kind = ReplayModel::Kind::kStraight;
  const Clip& clip = clips[c];
  const std::vector<Polyline> ways = replay(clip, straight, 0).ways;
  const VehicleWays vehicles(clip);
  std::vector<ScoredPerson> persons;
  for (std::size_t i = 0; i < clip.persons.size(); ++i) {
    const PersonTrack& track = clip.persons[i];
    if (!counts(track)) continue;
    ScoredPerson person;
    person.clip = static_cast<std::uint32_t>(c);
    person.person = static_cast<std::uint32_t>(i);
    person.recorded = measure(clip, vehicles, track, track.places);
    person.straight_clearance = measure(clip, vehicles, track, ways[i]).clearance;
    persons.push_back(person);
  }
  return persons;
}

ScoredRuns score(const std::vector<Clip>& clips, const ReplayModel& model, int seeds) {
  const std::size_t runs = static_cast<std::size_t>(seeds);
  std::vector<std::vector<ScoredPerson>> recorded(clips.size()), parts(clips.size() * runs);
  for_each_parallel(clips.size(), [&](std::size_t c) { recorded[c] = recorded_persons(clips, c); });
  for_each_parallel(parts.size(), [&](std::size_t k) {
    const std::size_t c = k % clips.size();
    const Clip& clip = clips[c];
    const Replayed replayed = replay(clip, model, k / clips.size() + 1);
    const VehicleWays vehicles(clip);
    parts[k] = recorded[c];
    for (ScoredPerson& person : parts[k]) {
      person.walked = measure(clip, vehicles, person.person, replayed);
    }
  });
  ScoredRuns scored(runs);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    std::vector<ScoredPerson>& run = scored[k / clips.size()];
    run.insert(run.end(), parts[k].begin(), parts[k].end());
  }
  return scored;
}

}  // namespace pedzone
