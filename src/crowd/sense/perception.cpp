// Phase: how each person perceives at present, and which vehicles it minds. Sight is blocked by
// walls of buildings and by parked or large vehicles; a vehicle counts once the person's reaction
// time is over; who is unaware of vehicles minds only those that are very near or sound their horn.
#include "crowd/sense/perception.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "crowd/sense/vehicle_motion.hpp"
#include "crowd/state/parallel.hpp"
#include "model/senses.hpp"
#include "model/tile_lists.hpp"
#include "model/vehicle_view.hpp"

namespace pedzone {
namespace {

constexpr double kMemory = 2.0;        // [s] assumed: so long a vehicle is minded unperceived ...
constexpr double kForget = 10.0;       // [s] ... and known, so that no new reaction time begins
constexpr float kStartled = 1.5F;      // [m] assumed: who is unaware jumps aside this near
constexpr float kDisturbs = 5.0F;      // [m] assumed: who stands makes room for a vehicle this near
constexpr double kWarnedField = 180.0;  // [deg] who hears a horn looks round

/// [m] side of the tiles that list vehicles, and at most so many of them. Numerical.
constexpr double kTile = 8.0;
constexpr double kTilesPerPerson = 8.0, kTilesAtLeast = 1024.0;

/// What all persons of a substep share: vehicles, and where they can matter.
struct TrafficShapes {
  LatticeOrigin origin;
  Senses senses;  ///< of who perceives as most do
  std::vector<VehicleShape> shapes;
  std::vector<std::uint32_t> driving;       ///< vehicles that move
  std::vector<std::uint64_t> driving_keys;  ///< their keys, sorted
  std::vector<std::uint32_t> blocking;      ///< vehicles that nobody sees through or over
  TileLists perceivable;  ///< places in `driving`, where somebody may perceive them
  TileLists in_view;      ///< places in `blocking`, where they may hide others
};

/// The lattice box round a vehicle that holds whoever is `range` [m] or less from its body.
LatticeBox box_around(const VehicleShape& shape, double range) {
  return box_round(shape.centre.x, shape.centre.y, to_lattice(range + shape.reach));
}

/// Lists the vehicles where they can matter: of a town's vehicles most are near nobody.
void list_by_place(const CrowdState& crowd, const Attention& attention, TrafficShapes& traffic) {
  const std::span<const double> x = crowd.persons.x, y = crowd.persons.y;
  const std::size_t walking = crowd.persons.walking;
  const LatticeBox bounds = bounds_of(x.first(walking), y.first(walking), traffic.origin);
  const std::int64_t tile =
      tile_size_for(bounds, to_lattice(kTile),
                    kTilesPerPerson * static_cast<double>(walking) + kTilesAtLeast);
  const double sight = traffic.senses.vehicle_sight;
  const auto everywhere = [](std::size_t, const LatticeBox&) { return true; };
  double longest = 0.0;
  for (const VehicleShape& shape : traffic.shapes) {
    longest = std::max(longest, 2.0 * static_cast<double>(shape.reach));
  }
  traffic.perceivable.build(
      bounds, tile, traffic.driving.size(),
      [&](std::size_t k) {
        const VehicleShape& shape = traffic.shapes[traffic.driving[k]];
        const double heard = shape.horn ? kHornReach : attention.farthest_hearing * shape.loudness;
        return box_around(shape, std::max({sight, heard, static_cast<double>(kDisturbs)}));
      },
      everywhere);
  // It hides what lies behind it, up to the far end of the longest vehicle in sight.
  traffic.in_view.build(
      bounds, tile, traffic.blocking.size(),
      [&](std::size_t k) {
        return box_around(traffic.shapes[traffic.blocking[k]], sight + longest);
      },
      everywhere);
}

TrafficShapes shapes_of(const CrowdState& crowd, const Attention& attention) {
  const std::vector<VehicleState>& vehicles = crowd.vehicles;
  TrafficShapes traffic;
  traffic.senses = senses_of(crowd.zone.parameters, crowd.model->vehicle_form());
  const Vec2& near = vehicles.front().centre;
  traffic.origin = {to_lattice(near.x()), to_lattice(near.y())};
  for (std::uint32_t v = 0; v < vehicles.size(); ++v) {
    traffic.shapes.push_back(shape_of(vehicles[v], traffic.origin));
    const bool moves = traffic.shapes[v].moving();
    if (moves) {
      traffic.driving.push_back(v);
      traffic.driving_keys.push_back(vehicles[v].key);
    }
    if (!moves || vehicles[v].length > kLargeVehicle) traffic.blocking.push_back(v);
  }
  std::ranges::sort(traffic.driving_keys);
  list_by_place(crowd, attention, traffic);
  return traffic;
}

/// One person's look at the vehicles.
class Observer {
 public:
  Observer(const CrowdState& crowd, const TrafficShapes& traffic, double now, std::size_t i,
           TrafficMemory& memory, Attention& attention)
      : crowd_(crowd),
        traffic_(traffic),
        now_(now),
        i_(i),
        memory_(memory),
        attention_(attention),
        perception_(attention.persons[i]),
        senses_(with(traffic.senses, perception_)),
        self_(onlooker(crowd.persons, i, traffic.origin)) {}

  void look() {
    for (Noticed& noticed : memory_.noticed) noticed.minds = noticed.near = false;
    for (const std::uint32_t k : traffic_.perceivable.at(self_.at)) look_at(traffic_.driving[k]);
    // Those that are too far away to be perceived are remembered.
    for (Noticed& noticed : memory_.noticed) {
      if (std::ranges::binary_search(traffic_.driving_keys, noticed.vehicle)) {
        noticed.minds = minds(noticed);
      }
    }
    std::erase_if(memory_.noticed,
                  [&](const Noticed& noticed) { return now_ - noticed.last > kForget; });
  }

 private:
  void look_at(std::size_t v) {
    const VehicleView view = view_of(traffic_.shapes[v], self_);
    Noticed* known = find(crowd_.vehicles[v].key);
    const bool perceived = perceives(v, view);
    if (perceived && known == nullptr) {
      known = &memory_.noticed.emplace_back(Noticed{crowd_.vehicles[v].key, now_});
    }
    if (known != nullptr) {
      if (perceived) known->last = now_;
      known->warned = known->warned || (perceived && traffic_.shapes[v].horn);
      known->near = known->near || view.distance < kDisturbs;  // a vehicle may have several parts
    }
    const bool counts = known != nullptr && minds(*known);
    if (!counts && view.distance > kStartled) attention_.ignore(i_, v);
  }

  Noticed* find(std::uint64_t key) {
    const auto found = std::ranges::find(memory_.noticed, key, &Noticed::vehicle);
    return found == memory_.noticed.end() ? nullptr : &*found;
  }

  bool perceives(std::size_t v, const VehicleView& view) const {
    switch (awareness(view, self_, senses_)) {
      case Awareness::kNone:
        return false;
      case Awareness::kHeard:
        return true;
      case Awareness::kSeen:
        return !hidden(v) || heard(view, senses_);
    }
    return false;
  }

  /// Whether neither its centre nor a corner is in view.
  bool hidden(std::size_t v) const {
    if (crowd_.zone.obstacles.empty() && traffic_.in_view.at(self_.at).empty()) return false;
    const VehicleState& vehicle = crowd_.vehicles[v];
    const Vec2 along = unit(vehicle.heading) * (0.5 * vehicle.length);
    const Vec2 across = left_of(unit(vehicle.heading)) * (0.5 * vehicle.width);
    for (const Vec2& offset : {Vec2(Vec2::Zero()), Vec2(along + across), Vec2(along - across),
                               Vec2(across - along), Vec2(-along - across)}) {
      if (sees(vehicle.centre + offset, v)) return false;
    }
    return true;
  }

  bool sees(const Vec2& point, std::size_t v) const {
    const Vec2 here = crowd_.position(i_);
    for (const std::uint32_t k : traffic_.in_view.at(self_.at)) {
      const std::uint32_t other = traffic_.blocking[k];
      if (other != v && runs_through(rectangle_of(crowd_.vehicles[other]), here, point)) {
        return false;
      }
    }
    return crowd_.zone.obstacles.empty() || crowd_.zone.sight_walls.free_line(here, point, 0.0);
  }

  bool minds(const Noticed& known) const {
    const double reaction =
        crowd_.walkers[i_].profile != nullptr ? crowd_.walkers[i_].profile->reaction_time : 0.0;
    return (memory_.aware || known.warned) && now_ - known.last <= kMemory &&
           now_ - known.since >= reaction;
  }

  const CrowdState& crowd_;
  const TrafficShapes& traffic_;
  double now_;  ///< [s]
  std::size_t i_;
  TrafficMemory& memory_;
  Attention& attention_;
  const Perception& perception_;
  Senses senses_;
  Walker self_;
};

Perception perception_of(const CrowdState& crowd, std::size_t i) {
  const WalkState& walker = crowd.walkers[i];
  const ActivityInfo& activity = info_of(crowd.activities[walker.handle].activity);
  Perception p{crowd.zone.parameters.field_of_view, crowd.zone.parameters.hearing, 1.0};
  if (walker.profile != nullptr) {
    p = {walker.profile->field_of_view, walker.profile->hearing, walker.profile->caution,
         walker.profile->top_speed};
  }
  p.field_of_view *= activity.field_of_view * crowd.zone.weather->field_of_view;
  p.hearing *= activity.hearing;
  if (std::ranges::any_of(crowd.traffic[walker.handle].noticed, &Noticed::warned)) {
    p.field_of_view = kWarnedField;
  }
  return p;
}

}  // namespace

bool perceives_otherwise(const CrowdState& crowd) {
  if (crowd.zone.weather->field_of_view != 1.0) return true;
  const bool views_blocked = !crowd.zone.obstacles.empty() || crowd.vehicles.size() > 1;
  if (!crowd.vehicles.empty() && views_blocked) return true;
  return std::ranges::any_of(crowd.walkers, [&](const WalkState& walker) {
    return walker.profile != nullptr ||
           crowd.activities[walker.handle].activity != Activity::kNone ||
           !crowd.traffic[walker.handle].aware;
  });
}

void set_perceptions(const CrowdState& crowd, Attention& attention) {
  const std::size_t walking = crowd.persons.walking;
  attention.persons.resize(walking);
  attention.words = (crowd.vehicles.size() + 63) / 64;
  attention.ignored.assign(walking * attention.words, 0);
  attention.widest_field = attention.farthest_hearing = 0.0;
  for (std::size_t i = 0; i < walking; ++i) {
    attention.persons[i] = perception_of(crowd, i);
    attention.widest_field = std::max(attention.widest_field, attention.persons[i].field_of_view);
    attention.farthest_hearing = std::max(attention.farthest_hearing, attention.persons[i].hearing);
  }
  // What people see of each other is looked up in cells: no new ones for each change.
  constexpr double kFieldStep = 15.0;  // [deg]
  attention.widest_field = std::ceil(attention.widest_field / kFieldStep) * kFieldStep;
}

void perceive(const CrowdState& crowd, double now, ByHandle<TrafficMemory>& memory,
              Attention& attention) {
  set_perceptions(crowd, attention);
  if (crowd.vehicles.empty() || crowd.persons.walking == 0) {
    for (std::size_t i = 0; i < crowd.persons.walking; ++i) memory[crowd.handle(i)].noticed.clear();
    return;
  }
  const TrafficShapes traffic = shapes_of(crowd, attention);
  for_each_block(
      crowd.persons.walking,
      [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
          Observer(crowd, traffic, now, i, memory[crowd.handle(i)], attention).look();
        }
      },
      Work::kDecision);
}

}  // namespace pedzone
