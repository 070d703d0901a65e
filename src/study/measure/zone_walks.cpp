#include "study/measure/zone_walks.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "core/statistics.hpp"
#include "study/measure/trip_measures.hpp"

namespace pedzone::study {
namespace {

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
}

void ZoneWalks::step(double dt, std::span<const Walker> walkers) {
  ++step_;
  for (const Walker& walker : walkers) {
    Person& person = persons_[walker.person];
    const bool goes_on = person.seen + 1 == step_ && person.walk == walker.walk;
    if (!goes_on) close(person);
    if (walker.walk != nullptr) {
      Amount since;
      if (goes_on) {
        since = {dt, walker.speed < kHaltingSpeed ? dt : 0.0, (walker.at - person.at).norm(),
                 walker.speed * dt};
      }
      follow(walker, since, person);
    }
    person.seen = step_;
    person.walk = walker.walk;
    person.at = walker.at;
  }
}

void ZoneWalks::follow(const Walker& walker, const Amount& since, Person& person) {
  Visit& visit = person.visit;
  if (visit.zone != Walker::kNowhere) {
    visit.gap.add(since);
    if (walker.zone == visit.zone) {
      visit.inside.add(visit.gap);
      visit.gap = {};
      visit.exit = walker.at;
    } else if (walker.zone != Walker::kNowhere || visit.gap.time > kGap) {
      close(person);
    }
  }
  if (visit.zone == Walker::kNowhere && walker.zone != Walker::kNowhere) {
    visit = {walker.zone, walker.walk, walker.at, walker.at, {}, {}};
    person.visitor = true;
  }
}

void ZoneWalks::close(Person& person) {
  const Visit visit = std::exchange(person.visit, {});
  if (visit.zone == Walker::kNowhere) return;
  person.total.add(visit.inside);
  const double shortest = shortest_way(zones_[visit.zone].ways, visit.entry, visit.exit);
  if (!std::isfinite(shortest)) return;
  person.shortest += shortest;
  person.walked += visit.inside.walked;
  person.delay = person.delay.value_or(0.0) + visit.inside.time -
                 shortest / (visit.walk->max_speed * free_share_);
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
  }
  if (total.time > 0.0) values["person.speed"] = total.covered / total.time;
  if (!delays.empty()) values["person.delay"] = mean(delays);
  add_percentiles("person.delay", delays, values);
  if (shortest > 0.0) values["person.detour"] = walked / shortest;
}

}  // namespace pedzone::study
