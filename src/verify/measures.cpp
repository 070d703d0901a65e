#include "verify/measures.hpp"

#include <algorithm>
#include <cmath>

#include "verify/voronoi.hpp"

namespace pedzone::verify {

// Flow

void FlowLine::look(const Trial& trial) {
  const auto& people = trial.people();
  for (std::size_t i = 0; i < people.size(); ++i) {
    const Participant& participant = people[i];
    if (!participant.here && participant.arrival < trial.time() - kStep / 2.0) continue;
    look(i, participant.before, participant.at, trial.time());
  }
}

void FlowLine::look(std::size_t person, const Vec2& before, const Vec2& at, double time) {
  const Vec2 along = b_ - a_;
  const double was = cross(along, before - a_), is = cross(along, at - a_);
  if (was >= 0.0 || is < 0.0) return;
  const double share = was / (was - is);
  const double place = (before + share * (at - before) - a_).dot(along) / along.squaredNorm();
  if (place < 0.0 || place > 1.0) return;
  passed_.emplace(person, time - (1.0 - share) * kStep);
}

std::vector<double> FlowLine::times() const {
  std::vector<double> times;
  for (const auto& [person, time] : passed_) times.push_back(time);
  std::ranges::sort(times);
  return times;
}

double FlowLine::flow(double from, double to) const {
  const std::vector<double> sorted = times();
  if (sorted.size() < 3) return 0.0;
  const double last = static_cast<double>(sorted.size() - 1);
  const auto first_rank = static_cast<std::size_t>(std::floor(from * last));
  const auto last_rank = static_cast<std::size_t>(std::ceil(to * last));
  const double taken = sorted[last_rank] - sorted[first_rank];
  return taken > 0.0 ? static_cast<double>(last_rank - first_rank) / taken : 0.0;
}

// Density and speed

namespace {

/// People near an end of a period once more beyond the other, so that cells end between people.
void add_beyond_ends(const Period& period, std::vector<Vec2>& points, std::vector<double>& values) {
  for (std::size_t i = 0, count = points.size(); i < count; ++i) {
    const Vec2 shift(period.length(), 0.0);
    const bool low = points[i].x() < period.low + Period::kBeyond;
    const bool high = points[i].x() > period.high - Period::kBeyond;
    for (const double way : {low ? 1.0 : 0.0, high ? -1.0 : 0.0}) {
      if (way == 0.0) continue;
      points.emplace_back(points[i] + way * shift);
      values.push_back(values[i]);
    }
  }
}

}  // namespace

void AreaMeasure::look(const Trial& trial, const std::function<Vec2(const Participant&)>& way) {
  if (!trial.at_every(every_)) return;
  const auto& people = trial.people();
  const bool measure = trial.time() >= from_ && then_.size() == people.size();
  std::vector<Vec2> points;
  std::vector<double> speeds;
  for (std::size_t i = 0; i < people.size() && measure; ++i) {
    if (!people[i].here) continue;
    points.push_back(people[i].at);
    const Vec2 velocity = (people[i].moved - then_[i]) / every_;
    speeds.push_back(way ? velocity.dot(way(people[i])) : velocity.norm());
  }
  if (measure && trial.period()) add_beyond_ends(*trial.period(), points, speeds);
  if (measure) {
    const VoronoiCells cells(trial.zone().walkable, points);
    const double density = cells.density(area_);
    density_ += density;
    ++moments_;
    if (const auto speed = cells.mean(speeds, area_)) {
      speed_ += density * *speed;
      weight_ += density;
    }
  }
  then_.resize(people.size());
  for (std::size_t i = 0; i < people.size(); ++i) then_[i] = people[i].moved;
}

DensityMap::DensityMap(const Vec2& low, const Vec2& high, double cell)
    : low_(low),
      cell_(cell),
      columns_(static_cast<std::size_t>(std::ceil((high.x() - low.x()) / cell - 1e-9))),
      rows_(static_cast<std::size_t>(std::ceil((high.y() - low.y()) / cell - 1e-9))),
      sums_(columns_ * rows_) {}

void DensityMap::look(const Trial& trial) {
  if (!trial.at_every(1.0)) return;
  ++moments_;
  for (const Participant& participant : trial.people()) {
    if (!participant.here) continue;
    const Vec2 place = (participant.at - low_) / cell_;
    if (place.x() < 0.0 || place.y() < 0.0) continue;
    const auto column = static_cast<std::size_t>(place.x());
    const auto row = static_cast<std::size_t>(place.y());
    if (column < columns_ && row < rows_) sums_[row * columns_ + column] += 1.0;
  }
}

GridMap DensityMap::grid() const {
  GridMap grid{low_, cell_, columns_, rows_, sums_};
  for (double& one : grid.values) one /= std::max(1, moments_) * cell_ * cell_;
  return grid;
}

// Lanes

namespace {

struct Band {
  double forth = 0.0, back = 0.0;
  double people() const { return forth + back; }
  double balance() const { return people() > 0.0 ? (forth - back) / people() : 0.0; }
};

std::vector<Band> bands_of(std::span<const LanePlace> people, double low, double high,
                           double band) {
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round((high - low) / band)));
  std::vector<Band> bands(count);
  for (const LanePlace& one : people) {
    const double place = (one.across - low) / (high - low) * static_cast<double>(count);
    const double last = static_cast<double>(count - 1);
    Band& its = bands[static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, last))];
    (one.way > 0 ? its.forth : its.back) += 1.0;
  }
  return bands;
}

}  // namespace

double band_index(std::span<const LanePlace> people, double low, double high, double band) {
  if (people.empty()) return 0.0;
  double sum = 0.0;
  for (const Band& one : bands_of(people, low, high, band)) {
    sum += one.people() * one.balance() * one.balance();
  }
  return sum / static_cast<double>(people.size());
}

int lane_count(std::span<const LanePlace> people, double low, double high, double band) {
  constexpr double kPrevails = 0.3;  // assumed: two of three go one way
  int lanes = 0, way = 0;
  for (const Band& one : bands_of(people, low, high, band)) {
    if (std::abs(one.balance()) < kPrevails) continue;
    const int its = one.balance() > 0.0 ? 1 : -1;
    if (its != way) ++lanes;
    way = its;
  }
  return lanes;
}

void Turns::look(const Trial& trial) {
  const auto& people = trial.people();
  angles_.resize(people.size());
  most_.resize(people.size());
  for (std::size_t i = 0; i < people.size(); ++i) {
    if (!people[i].here) continue;
    const Vec2 before = people[i].before - centre_, at = people[i].at - centre_;
    angles_[i] += std::atan2(cross(before, at), before.dot(at));
    most_[i] = std::max(most_[i], std::abs(angles_[i]));
  }
}

double Turns::most() const {
  return most_.empty() ? 0.0 : *std::ranges::max_element(most_) / (2.0 * kPi);
}

void Jolts::look(const Trial& trial) {
  const std::vector<Participant>& people = trial.people();
  moved_.resize(people.size(), Vec2::Zero());
  stopped_.resize(people.size(), 0);
  for (std::size_t i = 0; i < people.size(); ++i) {
    if (!people[i].here) continue;
    const Vec2 moved = people[i].at - people[i].before;
    const double before = moved_[i].norm();
    if (before > 0.0 && before - moved.dot(moved_[i]) / before > kJolt * kStep) stopped_[i] = 1;
    moved_[i] = moved;
  }
}

double Jolts::share() const {
  if (stopped_.empty()) return 0.0;
  return static_cast<double>(std::ranges::count(stopped_, 1)) /
         static_cast<double>(stopped_.size());
}

}  // namespace pedzone::verify
