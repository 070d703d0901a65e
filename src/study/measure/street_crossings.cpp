#include "study/measure/street_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "study/measure/conflict_measures.hpp"
#include "world/speeds.hpp"

namespace pedzone::study {
namespace {

constexpr double kKerb = 3.0;       // [m] assumed: who is nearer to the carriageway is at the kerb
constexpr double kWaits = 0.3;      // [m/s] assumed: who is slower waits
constexpr double kOnRoad = 0.3;     // [m] assumed: a step beside the kerb is no crossing
constexpr double kUpstream = 30.0;  // [m] numerical: how far beyond its ends vehicles are followed

/// [s] When the person was at the conflict's place, or on its way there: after a PET that may be
/// long ago.
double presence(const Conflict& conflict) {
  const Extreme moment = moment_of(conflict);
  const bool by_pet = !conflict.contact && !conflict.ttc && conflict.pet;
  return by_pet && conflict.first == First::kPerson ? moment.time - moment.value : moment.time;
}

}  // namespace

/// Vehicles that have come by a place between `from` and `to` [m].
void StreetWatch::pass(double time, double from, double to) {
  for (auto& [id, pedestrian] : people_) {
    const bool passed = (pedestrian.s - from) * (pedestrian.s - to) <= 0.0 && from != to;
    if (!passed || (!pedestrian.at_kerb && !pedestrian.on_road)) continue;
    const double gap = time - pedestrian.ready;
    if (pedestrian.on_road) {
      if (!pedestrian.gap) pedestrian.gap = gap;
    } else {
      if (gap > 0.0) pedestrian.let_pass.push_back(gap);
      pedestrian.ready = time;
    }
  }
  for (auto entry = awaited_.begin(); entry != awaited_.end();) {
    const Watched& pedestrian = people_.at(entry->first);
    const bool passed = (pedestrian.s - from) * (pedestrian.s - to) <= 0.0 && from != to;
    if (passed) all_[entry->second].gap = time - pedestrian.ready;
    entry = passed ? awaited_.erase(entry) : std::next(entry);
  }
}

void StreetWatch::note_passes(double time, std::span<const VehicleSample> vehicles) {
  std::unordered_map<std::string, double> fronts;
  for (const VehicleSample& vehicle : vehicles) {
    if (vehicle.part > 0) continue;
    const Vec2 ahead = unit(vehicle.heading);
    const StreetPlace at = street_->place(vehicle.centre + 0.5 * vehicle.length * ahead);
    const bool here = at.t > street_->low && at.t < street_->high && at.s > -kUpstream &&
                      at.s < street_->length + kUpstream;
    if (!here) continue;
    const std::string id(vehicle.id);
    fronts[id] = at.s;
    if (const auto before = fronts_.find(id); before != fronts_.end()) {
      pass(time, before->second, at.s);
    }
  }
  fronts_ = std::move(fronts);
}

/// It is on the ground of one side: has it come from the other?
void StreetWatch::stand_on(double time, Side side, Watched& pedestrian, const std::string& id) {
  const bool crossed = pedestrian.side != Side::kUnknown && pedestrian.side != side;
  if (crossed) {
    SeenCrossing crossing{
        .person = id, .between = pedestrian.on_road, .begin = pedestrian.since, .end = time};
    if (crossing.between) {
      crossing.waited = pedestrian.waited;
      crossing.gap = pedestrian.gap;
      crossing.let_pass = std::move(pedestrian.let_pass);
      if (!crossing.gap) awaited_[id] = all_.size();
    }
    all_.push_back(std::move(crossing));
    from_.push_back(pedestrian.side);
  }
  if (crossed || pedestrian.on_road) {
    const Watched before = std::exchange(pedestrian, {});
    pedestrian.s = before.s;  // where the next vehicle is awaited
    pedestrian.ready = before.ready;
  }
  pedestrian.side = side;
  pedestrian.since = time;
}

void StreetWatch::count_conflict(const Conflict& conflict, Side from,
                                 SeenCrossing& crossing) const {
  const double time = presence(conflict);
  if (time < crossing.begin || time > crossing.end) return;
  const StreetPlace at = street_->place(moment_of(conflict).position);
  if (at.s < 0.0 || at.s > street_->length) return;
  const CrossingPlace& place = street_->at(at.s);
  if (at.t < place.low || at.t > place.high) return;
  const Side half = at.t < street_->divide() ? Side::kLow : Side::kHigh;
  (half == from ? crossing.near_conflicts : crossing.far_conflicts) += 1.0;
}

void StreetWatch::count_conflicts(const ConflictsOf& conflicts) {
  for (std::size_t k = 0; k < all_.size(); ++k) {
    if (!all_[k].between) continue;
    const auto [first, last] = conflicts.equal_range(all_[k].person);
    for (auto one = first; one != last; ++one) count_conflict(*one->second, from_[k], all_[k]);
  }
}

void StreetWatch::step(double time, double dt, std::span<const PersonSample> persons,
                       std::span<const VehicleSample> vehicles) {
  for (const PersonSample& person : persons) {
    if (!person.rides_in.empty()) continue;
    const StreetPlace at = street_->place(person.position);
    if (at.s < 0.0 || at.s > street_->length) continue;
    const CrossingPlace& place = street_->at(at.s);
    if (at.t < place.low - kKerb || at.t > place.high + kKerb) continue;
    const std::string id(person.id);
    const auto [entry, is_new] = people_.try_emplace(id);
    Watched& pedestrian = entry->second;
    if (at.t > place.low + kOnRoad && at.t < place.high - kOnRoad) {
      if (pedestrian.side == Side::kUnknown) continue;
      if (!pedestrian.on_road) pedestrian.s = at.s;
      pedestrian.on_road = true;
      continue;
    }
    const Side side = at.t < 0.5 * (place.low + place.high) ? Side::kLow : Side::kHigh;
    if (side != pedestrian.side || pedestrian.on_road) stand_on(time, side, pedestrian, id);
    if (awaited_.contains(id)) continue;  // its next vehicle first
    if (!pedestrian.at_kerb) pedestrian.ready = time;
    pedestrian.at_kerb = true;
    pedestrian.s = at.s;
    if (person.velocity.norm() < kWaits) {
      pedestrian.waited += dt;
    } else if (pedestrian.waited <= 0.0) {
      pedestrian.ready = time;  // walks by: what has passed before is nothing to it
      pedestrian.let_pass.clear();
    }
  }
  note_passes(time, vehicles);
}

StreetCrossings::StreetCrossings(const std::vector<Zone>& zones) {
  for (const Zone& zone : zones) {
    for (const Street& street : zone.streets) streets_.emplace_back(street);
  }
}

void StreetCrossings::step(double time, double dt, std::span<const PersonSample> persons,
                           std::span<const VehicleSample> vehicles) {
  for (StreetWatch& street : streets_) street.step(time, dt, persons, vehicles);
}

void StreetCrossings::count_conflicts(std::span<const Conflict> conflicts) {
  ConflictsOf of;
  for (const Conflict& conflict : conflicts) {
    if (is_insertion(conflict) || !with_moving_vehicle(conflict)) continue;
    of.emplace(conflict.person, &conflict);
  }
  for (StreetWatch& street : streets_) street.count_conflicts(of);
}

std::vector<SeenCrossing> StreetCrossings::all() const {
  std::vector<SeenCrossing> all;
  for (const StreetWatch& street : streets_) {
    all.insert(all.end(), street.all().begin(), street.all().end());
  }
  return all;
}

std::string crossings_csv(std::span<const SeenCrossing> crossings) {
  std::string text = seen_crossing_table().header();
  for (const SeenCrossing& one : crossings) seen_crossing_table().append(text, one);
  return text;
}

std::vector<GapChoice> gap_choices(std::span<const SeenCrossing> crossings) {
  std::vector<GapChoice> choices;
  for (const SeenCrossing& crossing : crossings) {
    if (!crossing.between) continue;
    if (crossing.gap) choices.push_back({*crossing.gap, true});
    for (const double gap : crossing.let_pass) choices.push_back({gap, false});
  }
  return choices;
}

void StreetCrossings::finish(std::map<std::string, double>& values) const {
  if (streets_.empty()) return;
  const std::vector<SeenCrossing> seen = all();
  double between = 0.0, waited = 0.0, near = 0.0, far = 0.0;
  for (const SeenCrossing& crossing : seen) {
    if (!crossing.between) continue;
    between += 1.0;
    waited += crossing.waited;
    near += crossing.near_conflicts;
    far += crossing.far_conflicts;
  }
  values["crossing.count"] = static_cast<double>(seen.size());
  if (!seen.empty()) values["crossing.between"] = between / static_cast<double>(seen.size());
  if (between > 0.0) values["crossing.wait"] = waited / between;
  values["crossing.near"] = near;
  values["crossing.far"] = far;
  if (const auto fit = fit_gap_acceptance(gap_choices(seen))) values["crossing.gap"] = fit->median;
}

}  // namespace pedzone::study
