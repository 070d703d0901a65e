// Phase: how each person perceives at present, and which vehicles it minds. Sight is blocked by
// walls of buildings and by parked or large vehicles; a vehicle counts once the person's reaction
// time is over; who is unaware of vehicles minds only those that are very near or sound their horn.
#include <algorithm>
#include <cmath>

#include "crowd/parallel.hpp"
#include "crowd/state.hpp"
#include "model/senses.hpp"
#include "model/vehicle_view.hpp"

namespace pedzone {
namespace {

constexpr double kMemory = 2.0;        // [s] assumed: so long a vehicle is minded unperceived ...
constexpr double kForget = 10.0;       // [s] ... and known, so that no new reaction time begins
constexpr float kLastMoment = 1.5F;    // [m] assumed: who is unaware jumps aside this near
constexpr float kDisturbs = 5.0F;      // [m] assumed: who stands makes room for a vehicle this near
constexpr double kLargeVehicle = 6.0;  // [m] assumed: longer vehicles are too high to see over
constexpr double kWarnedField = 180.0;  // [deg] who hears a horn looks round

/// What all persons of a substep share.
struct Traffic {
  LatticeOrigin origin;
  std::vector<VehicleShape> shapes;
  std::vector<std::uint32_t> blocking;  ///< vehicles that nobody sees through or over
};

Traffic traffic_of(const std::vector<VehicleState>& vehicles) {
  Traffic traffic;
  if (vehicles.empty()) return traffic;
  const Vec2& near = vehicles.front().centre;
  traffic.origin = {to_lattice(near.x()), to_lattice(near.y())};
  for (std::size_t v = 0; v < vehicles.size(); ++v) {
    traffic.shapes.push_back(shape_of(vehicles[v], traffic.origin));
    if (!traffic.shapes[v].moving() || vehicles[v].length > kLargeVehicle) {
      traffic.blocking.push_back(static_cast<std::uint32_t>(v));
    }
  }
  return traffic;
}

/// Whether the line from a to b runs through the vehicle.
bool cuts(const VehicleState& vehicle, const Vec2& a, const Vec2& b) {
  const Vec2 axis = unit(vehicle.heading), from = a - vehicle.centre, to = b - vehicle.centre;
  const Vec2 p(axis.dot(from), cross(axis, from)), q(axis.dot(to), cross(axis, to));
  double enter = 0.0, leave = 1.0;
  const double half[] = {0.5 * vehicle.length, 0.5 * vehicle.width};
  for (int k = 0; k < 2; ++k) {
    const double way = q[k] - p[k];
    if (std::abs(way) < 1e-9) {
      if (std::abs(p[k]) > half[k]) return false;
      continue;
    }
    const double first = (-half[k] - p[k]) / way, second = (half[k] - p[k]) / way;
    enter = std::max(enter, std::min(first, second));
    leave = std::min(leave, std::max(first, second));
  }
  return enter < leave;
}

/// One person's look at the vehicles.
class Observer {
 public:
  Observer(CrowdState& crowd, const Traffic& traffic, std::size_t i)
      : crowd_(crowd),
        traffic_(traffic),
        i_(i),
        walker_(crowd.walkers[i]),
        perception_(crowd.attention.persons[i]),
        senses_(
            with(senses_of(crowd.zone.parameters, vehicle_form(crowd.zone.model)), perception_)) {
    const Persons& persons = crowd.persons;
    self_.at = to_lattice(persons.x[i], persons.y[i], traffic.origin);
    self_.heading = persons.heading[i];
    self_.heading_cos = static_cast<float>(std::cos(self_.heading));
    self_.heading_sin = static_cast<float>(std::sin(self_.heading));
    self_.radius = static_cast<float>(persons.radius[i]);
  }

  void look() {
    for (Noticed& noticed : walker_.noticed) noticed.minds = noticed.near = false;
    for (std::size_t v = 0; v < traffic_.shapes.size(); ++v) {
      if (traffic_.shapes[v].moving()) look_at(v);
    }
    std::erase_if(walker_.noticed,
                  [&](const Noticed& noticed) { return crowd_.clock - noticed.last > kForget; });
  }

 private:
  void look_at(std::size_t v) {
    const VehicleView view = view_of(traffic_.shapes[v], self_);
    Noticed* known = find(crowd_.vehicles[v].key);
    const bool perceived = perceives(v, view);
    if (perceived && known == nullptr) {
      known = &walker_.noticed.emplace_back(Noticed{crowd_.vehicles[v].key, crowd_.clock});
    }
    if (known != nullptr) {
      if (perceived) known->last = crowd_.clock;
      known->warned = known->warned || (perceived && traffic_.shapes[v].horn);
      known->minds = minds(*known);
      known->near = view.distance < kDisturbs;
    }
    const bool counts = known != nullptr && known->minds;
    if (!counts && view.distance > kLastMoment) crowd_.attention.ignore(i_, v);
  }

  Noticed* find(std::uint64_t key) {
    const auto found = std::ranges::find(walker_.noticed, key, &Noticed::vehicle);
    return found == walker_.noticed.end() ? nullptr : &*found;
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
    if (crowd_.zone.obstacles.empty() && traffic_.blocking.empty()) return false;
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
    for (const std::uint32_t other : traffic_.blocking) {
      if (other != v && cuts(crowd_.vehicles[other], here, point)) return false;
    }
    return crowd_.zone.obstacles.empty() || crowd_.zone.sight_walls.free_line(here, point, 0.0);
  }

  bool minds(const Noticed& known) const {
    const double reaction = walker_.profile != nullptr ? walker_.profile->reaction_time : 0.0;
    return (walker_.aware || known.warned) && crowd_.clock - known.last <= kMemory &&
           crowd_.clock - known.since >= reaction;
  }

  CrowdState& crowd_;
  const Traffic& traffic_;
  std::size_t i_;
  WalkState& walker_;
  const Perception& perception_;
  Senses senses_;
  Walker self_;
};

Perception perception_of(const Zone& zone, const WalkState& walker) {
  const ActivityInfo& activity = info_of(walker.activity);
  Perception p{zone.parameters.field_of_view, zone.parameters.hearing, 1.0};
  if (walker.profile != nullptr) {
    p = {walker.profile->field_of_view, walker.profile->hearing, walker.profile->caution};
  }
  p.field_of_view *= activity.field_of_view * zone.weather->field_of_view;
  p.hearing *= activity.hearing;
  if (std::ranges::any_of(walker.noticed, &Noticed::warned)) p.field_of_view = kWarnedField;
  return p;
}

/// Whether anybody perceives otherwise than the parameters say.
bool anybody_differs(const CrowdState& crowd) {
  if (crowd.zone.weather->field_of_view != 1.0) return true;
  const bool views_blocked = !crowd.zone.obstacles.empty() || crowd.vehicles.size() > 1;
  if (!crowd.vehicles.empty() && views_blocked) return true;
  return std::ranges::any_of(crowd.walkers, [](const WalkState& walker) {
    return walker.profile != nullptr || walker.activity != Activity::kNone || !walker.aware;
  });
}

}  // namespace

void perceive(CrowdState& crowd, double dt) {
  crowd.clock += dt;
  crowd.differs = anybody_differs(crowd);
  if (!crowd.differs) return;
  const std::size_t walking = crowd.persons.walking;
  Attention& attention = crowd.attention;
  attention.persons.resize(walking);
  attention.words = (crowd.vehicles.size() + 63) / 64;
  attention.ignored.assign(walking * attention.words, 0);
  attention.widest_field = attention.farthest_hearing = 0.0;
  for (std::size_t i = 0; i < walking; ++i) {
    attention.persons[i] = perception_of(crowd.zone, crowd.walkers[i]);
    attention.widest_field = std::max(attention.widest_field, attention.persons[i].field_of_view);
    attention.farthest_hearing = std::max(attention.farthest_hearing, attention.persons[i].hearing);
  }
  // What people see of each other is looked up in cells: no new ones for each change.
  constexpr double kFieldStep = 15.0;  // [deg]
  attention.widest_field = std::ceil(attention.widest_field / kFieldStep) * kFieldStep;
  if (crowd.vehicles.empty()) {
    for (WalkState& walker : crowd.walkers) walker.noticed.clear();
    return;
  }
  const Traffic traffic = traffic_of(crowd.vehicles);
  for_each_block(walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) Observer(crowd, traffic, i).look();
  });
}

}  // namespace pedzone
