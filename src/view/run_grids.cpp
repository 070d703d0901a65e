#include "view/run_grids.hpp"

#include <algorithm>
#include <cmath>

#include "view/run_map.hpp"

namespace pedzone {
namespace {

constexpr double kMinute = 60.0;    // [s]
constexpr double kRounding = 1e-6;  // [s] of sums of times

/// What a cell has seen.
struct Visits {
  std::vector<double> seconds;  ///< [s] of people, by minute
  double all = 0.0;             ///< [s] of people
  double way = 0.0;             ///< [m]
};

/// [s] for how long each step stands: until the next one. Where the recording pauses, nobody was
/// there.
std::vector<double> durations(const Recording& recording) {
  const double gap = line_gap(recording);
  const auto& times = recording.times;
  std::vector<double> steps(times.size(), gap);
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    steps[i] = std::min(gap, times[i + 1] - times[i]);
  }
  if (steps.size() > 1) steps.back() = steps[steps.size() - 2];
  return steps;
}

class Collector {
 public:
  Collector(const Recording& recording, const Box& box, double cell)
      : recording_(recording), box_(box), steps_(durations(recording)), grids_(cell) {
    grids_.begin = recording.begin;
    grids_.end = std::max(recording.end, recording.times.back() + steps_.back());
    const double duration = grids_.end - grids_.begin;
    length_ = std::min(duration, kMinute);
    for (double since = 0.0; since + length_ <= duration + kRounding; since += length_) {
      minutes_.push_back(grids_.begin + since);
    }
    if (duration - length_ > minutes_.back() - grids_.begin + kRounding) {
      minutes_.push_back(grids_.end - length_);
    }
    people_.resize(minutes_.size());
  }

  RunGrids collect() {
    for (const RecordedPerson& person : recording_.persons) {
      for (const PersonMoment& moment : person.moments) {
        if (box_.contains(moment.position)) add(moment);
      }
    }
    const auto peak = static_cast<std::size_t>(std::ranges::max_element(people_) - people_.begin());
    grids_.minute_begin = minutes_[peak];
    grids_.minute_end = grids_.minute_begin + length_;
    for (const auto& [cell, visits] : visits_) finish(cell, visits, peak);
    if (!visits_.empty()) grids_.mean_where_people /= static_cast<double>(visits_.size());
    return grids_;
  }

 private:
  void add(const PersonMoment& moment) {
    const double seconds = steps_[moment.step];
    Visits& visits = visits_[grids_.mean.cell_at(moment.position)];
    visits.all += seconds;
    visits.way += seconds * moment.speed;
    visits.seconds.resize(people_.size());
    const double time = recording_.times[moment.step];
    const auto count_in = [&](std::size_t minute) {
      const double since = time - minutes_[minute];
      if (since < -kRounding || since >= length_ - kRounding) return;
      people_[minute] += seconds;
      visits.seconds[minute] += seconds;
    };
    const std::size_t last = minutes_.size() - 1;
    const auto in_turn = static_cast<std::size_t>((time - grids_.begin + kRounding) / length_);
    if (in_turn < last) count_in(in_turn);
    count_in(last);  // it may have begun before the one in turn is over
  }

  void finish(const ValueGrid::Cell& cell, const Visits& visits, std::size_t peak) {
    const double size = grids_.mean.size, area = size * size;
    const double density = visits.all / (grids_.end - grids_.begin) / area;
    grids_.mean.cells[cell] = density;
    grids_.mean_where_people += density;
    if (visits.all > 0.0) grids_.speed.cells[cell] = visits.way / visits.all;
    for (std::size_t minute = 0; minute < visits.seconds.size(); ++minute) {
      const double then = visits.seconds[minute] / length_ / area;
      if (minute == peak && then > 0.0) {
        grids_.minute.cells[cell] = then;
        grids_.area[service_level(then)] += area;
      }
      if (then <= grids_.most) continue;
      grids_.most = then;
      grids_.most_begin = minutes_[minute];
      grids_.most_at = size * Vec2(cell.first + 0.5, cell.second + 0.5);
    }
  }

  const Recording& recording_;
  Box box_;
  std::vector<double> steps_;    ///< [s]
  double length_ = kMinute;      ///< [s] of a minute; less where the run is shorter
  std::vector<double> minutes_;  ///< [s] when each begins: in turn, and one that ends with the run
  std::vector<double> people_;   ///< [s] of all people in the box, by minute
  std::map<ValueGrid::Cell, Visits> visits_;
  RunGrids grids_;
};

}  // namespace

RunGrids run_grids(const Recording& recording, const Box& box, double cell) {
  return Collector(recording, box, cell).collect();
}

}  // namespace pedzone
