#include "study/measure/zone_walks.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "core/statistics.hpp"
#include "study/measure/trip_measures.hpp"

namespace pedzone::study {
namespace {

constexpr double kJump = 1.0;  // [m] assumed: no rounding, nor who is pushed aside

/// Length [m] of a shortest way, infinite where there is none. It ends with the part from the last
/// place with room for the body, which the way finder leaves out.
double shortest_way(const WayFinder& ways, const Vec2& from, const Vec2& to) {
  const std::optional<Polyline> way = ways.way(from, to);
  if (!way) return std::numeric_limits<double>::infinity();
  double length = 0.0;
  Vec2 last = from;
  for (const Vec2& point : *way) {
    length += (point - last).norm();
    last = point;
  }
  return length + (to - last).norm();
}

}  // namespace

ZoneWalks::ZoneWalks(const Trips& trips, const std::vector<Zone>& zones, double free_share)
    : zones_(zones), free_share_(free_share), persons_(trips.persons.size()) {}

void ZoneWalks::Amount::add(const Amount& other) {
  time += other.time;
  waiting += other.waiting;
  walked += other.walked;
  covered += other.covered;
  jumped += other.jumped;
}

void ZoneWalks::add(const Presence& presence) {
  if (!presence.walks()) return;
  const Pedestrian& pedestrian = presence.pedestrian;
  Person& person = persons_[pedestrian.person];
  person.visitor = true;
  if (person.visit) {
    const Presence& last = person.visit->last;
    const bool goes_on = last.zone == presence.zone && last.pedestrian.walk == pedestrian.walk &&
                         last.step.number + 1 == presence.step.number;
    if (!goes_on) close(person);
  }
  if (!person.visit) {
    person.visit = {presence, presence, {}};
    return;
  }
  const double dt = presence.step.dt;
  const double walked = (pedestrian.at - person.visit->last.pedestrian.at).norm();
  const double covered = pedestrian.speed * dt, jumped = walked - covered;
  person.visit->amount.add({dt, pedestrian.speed < kHaltingSpeed ? dt : 0.0, walked, covered,
                            jumped > kJump ? jumped : 0.0});
  person.visit->last = presence;
}

void ZoneWalks::close(Person& person) {
  if (!person.visit) return;
  const Visit visit = *std::exchange(person.visit, {});
  person.total.add(visit.amount);
  const WayFinder& ways = zones_[static_cast<std::size_t>(visit.first.zone)].ways;
  const double shortest = shortest_way(ways, visit.first.pedestrian.at, visit.last.pedestrian.at);
  if (!std::isfinite(shortest)) return;
  person.shortest += shortest;
  person.walked += visit.amount.walked;
  person.delay = person.delay.value_or(0.0) + visit.amount.time -
                 shortest / (visit.first.pedestrian.walk->max_speed * free_share_);
}

void ZoneWalks::finish(std::map<std::string, double>& values) {
  Amount total;
  double visitors = 0.0, walked = 0.0, shortest = 0.0;
  std::vector<double> delays;
  for (Person& person : persons_) {
    close(person);
    if (!person.visitor) continue;
    visitors += 1.0;
    total.add(person.total);
    if (!person.delay) continue;
    delays.push_back(*person.delay);
    walked += person.walked;
    shortest += person.shortest;
  }
  values["person.visitors"] = visitors;
  if (visitors > 0.0) {
    values["person.waiting"] = total.waiting / visitors;
    values["person.walked"] = total.walked / visitors;
    values["person.jumped"] = total.jumped / visitors;
  }
  if (total.time > 0.0) values["person.speed"] = total.covered / total.time;
  if (!delays.empty()) values["person.delay"] = mean(delays);
  add_percentiles("person.delay", delays, values);
  if (shortest > 0.0) values["person.detour"] = walked / shortest;
}

}  // namespace pedzone::study
