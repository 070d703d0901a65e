#include "study/measure/zone_stays.hpp"

#include <algorithm>

namespace pedzone::study {

ZoneStays::ZoneStays(const Trips& trips, const Network& network, const std::vector<Zone>& zones)
    : stays_(trips.persons.size()) {
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

void ZoneStays::step(double time, std::span<const Walker> walkers) {
  for (const Walker& walker : walkers) {
    std::vector<Stay>& stays = stays_[walker.person];
    const int now = where(walker.edge);
    if (stays.empty() || stays.back().where != now) stays.push_back({time, now});
  }
}

bool ZoneStays::cover(std::string_view person, double time) const {
  const auto found = index_.find(person);
  if (found == index_.end()) return false;
  const std::vector<Stay>& stays = stays_[found->second];
  const auto next = std::ranges::upper_bound(stays, time, {}, &Stay::begin);
  if (next == stays.begin()) return false;
  const auto now = std::prev(next);
  if (now->where != kJunction) return now->where != kOutside;
  const int before = now == stays.begin() ? kOutside : std::prev(now)->where;
  const int after = next == stays.end() ? before : next->where;
  return before != kOutside && before == after;
}

}  // namespace pedzone::study
