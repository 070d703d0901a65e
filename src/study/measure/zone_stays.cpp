#include "study/measure/zone_stays.hpp"

#include <algorithm>

namespace pedzone::study {

ZoneStays::ZoneStays(const Trips& trips, const Network& network, const std::vector<Zone>& zones)
    : persons_(trips.persons.size()) {
  for (std::size_t i = 0; i < trips.persons.size(); ++i) index_[trips.persons[i].id] = i;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    for (const int edge : zones[i].edges) {
      zone_of_edge_[network.edges[static_cast<std::size_t>(edge)].id] = static_cast<int>(i);
    }
  }
}

int ZoneStays::where(std::string_view edge) const {
  if (edge.starts_with(':')) return kJunction;
  const auto found = zone_of_edge_.find(edge);
  return found == zone_of_edge_.end() ? kOutside : found->second;
}

std::span<const Presence> ZoneStays::step(const RunStep& step,
                                          std::span<const Pedestrian> pedestrians,
                                          std::span<const Closeness> closeness) {
  known_.clear();
  for (std::size_t i = 0; i < pedestrians.size(); ++i) {
    Person& person = persons_[pedestrians[i].person];
    const int now = where(pedestrians[i].edge);
    if (person.stays.empty() || person.stays.back().where != now) {
      person.stays.push_back({step.time, now});
    }
    const bool same_zone = now == kJunction || now == person.last_edge;
    if (!same_zone) person.junction.clear();
    if (now != kJunction) person.last_edge = now;
    if (person.last_edge == kOutside) continue;
    Presence presence{step, pedestrians[i], person.last_edge, closeness[i]};
    presence.pedestrian.edge = {};
    person.junction.push_back(presence);
    if (now != kJunction) settle(person);
  }
  return known_;
}

std::span<const Presence> ZoneStays::finish() {
  known_.clear();
  for (Person& person : persons_) settle(person);
  return known_;
}

void ZoneStays::settle(Person& person) {
  known_.insert(known_.end(), person.junction.begin(), person.junction.end());
  person.junction.clear();
}

bool ZoneStays::cover(std::string_view person, double time) const {
  const auto found = index_.find(person);
  if (found == index_.end()) return false;
  const std::vector<Stay>& stays = persons_[found->second].stays;
  const auto next = std::ranges::upper_bound(stays, time, {}, &Stay::begin);
  if (next == stays.begin()) return false;
  const auto now = std::prev(next);
  if (now->where != kJunction) return now->where != kOutside;
  const int before = now == stays.begin() ? kOutside : std::prev(now)->where;
  const int after = next == stays.end() ? before : next->where;
  return before != kOutside && before == after;
}

}  // namespace pedzone::study
