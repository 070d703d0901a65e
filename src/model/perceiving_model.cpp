#include "model/perceiving_model.hpp"

#include <algorithm>
#include <tuple>

#include "geometry/segment.hpp"
#include "model/trigonometry.hpp"

namespace pedzone {
namespace {

/// Assumed: share of the preferred speed below which somebody is hindered.
constexpr double kHindered = 0.5;

/// [m] from the person to a lattice point, exactly.
Vec2 offset_to(const LatticePoint& point, const LatticePoint& from) {
  return Vec2(point.x - from.x, point.y - from.y) / kLatticePerMetre;
}

Vec2 turned(const Vec2& v, double cos, double sin) {
  return {v.x() * cos - v.y() * sin, v.x() * sin + v.y() * cos};
}

/// Sorts by distance, and by all that tells two apart at one distance.
void sort(std::vector<Neighbour>& list) {
  std::ranges::sort(list, {}, [](const Neighbour& n) {
    return std::tuple(n.distance, n.offset.x(), n.offset.y(), n.velocity.x(), n.velocity.y(),
                      n.radius);
  });
}

void sort(std::vector<Border>& list) {
  std::ranges::sort(list, {}, [](const Border& w) {
    return std::tuple(w.distance, w.nearest.x(), w.nearest.y(), w.a.x(), w.a.y(), w.b.x(), w.b.y());
  });
}

void sort(std::vector<SeenVehicle>& list) {
  std::ranges::sort(list, {}, [](const SeenVehicle& v) {
    return std::tuple(v.distance, v.centre.x(), v.centre.y(), v.axis.x(), v.axis.y(), v.half_length,
                      v.half_width, v.velocity.x(), v.velocity.y());
  });
}

/// The nearest point of the outline and the way out, in the vehicle's frame: p is the person.
void place(const Vec2& p, SeenVehicle& v) {
  const Vec2 half(v.half_length, v.half_width);
  const Vec2 out = p.cwiseAbs() - half;  // < 0: between the two sides
  const Vec2 side(p.x() < 0.0 ? -1.0 : 1.0, p.y() < 0.0 ? -1.0 : 1.0);
  const Vec2 beyond = out.cwiseMax(0.0);
  v.distance = beyond.norm();
  if (v.distance > 0.0) {
    v.away = beyond.cwiseProduct(side) / v.distance;
  } else {  // inside: out through the nearest side
    v.away = out.x() > out.y() ? Vec2(side.x(), 0.0) : Vec2(0.0, side.y());
    v.distance = out.maxCoeff();
  }
  v.nearest = -v.distance * v.away;
}

SeenVehicle seen(const VehicleShape& shape, const LatticePoint& from) {
  SeenVehicle v;
  v.centre = offset_to(shape.centre, from);
  v.axis = Vec2(shape.cos, shape.sin);
  v.velocity = Vec2(shape.vx, shape.vy);
  v.half_length = shape.half_length;
  v.half_width = shape.half_width;
  v.moving = shape.moving();
  place(turned(-v.centre, v.axis.x(), -v.axis.y()), v);
  v.away = turned(v.away, v.axis.x(), v.axis.y());
  v.nearest = turned(v.nearest, v.axis.x(), v.axis.y());
  return v;
}

}  // namespace

void PerceivingModel::prepare(const Snapshot& snapshot) {
  snapshot_ = snapshot;
  scenery_.prepare(snapshot, vehicle_form(), reach_);
}

void PerceivingModel::decide(std::size_t first, std::size_t last,
                             std::span<Decision> decisions) const {
  static thread_local Perceived who;
  for (std::size_t i = first; i < last; ++i) {
    perceive(i, who);
    decisions[i] = decide_from(who);
    if (is_hindered(decisions[i], who)) {
      see_persons(i, true, scenery_.walker(i), scenery_.senses_of(i), who);
      decisions[i] = decide_from(who);
      decisions[i].turns = true;
    }
    decisions[i].speed = std::clamp(decisions[i].speed, 0.0, who.speed);
  }
}

/// Gets on slowly, and somebody ahead is near.
bool PerceivingModel::is_hindered(const Decision& decision, const Perceived& who) const {
  const double gain = decision.speed * unit(decision.direction).dot(who.goal_direction);
  if (gain > kHindered * who.speed) return false;
  const double reach = who.speed * who.parameters->turn_time;
  return std::ranges::any_of(who.neighbours, [&](const Neighbour& other) {
    return other.offset.dot(who.goal_direction) > 0.0 &&
           other.distance - who.radius - other.radius < reach;
  });
}

Decision PerceivingModel::walk_with(const Vec2& velocity, const Perceived& who) {
  Decision decision;
  decision.speed = velocity.norm();
  decision.direction = angle_of(decision.speed > 0.0 ? velocity : who.goal_direction);
  decision.free_distance = who.parameters->sight;
  return decision;
}

void PerceivingModel::perceive(std::size_t i, Perceived& who) const {
  const Persons& persons = *snapshot_.persons;
  const Walker walker = scenery_.walker(i);
  const Senses senses = scenery_.senses_of(i);
  const SineCosine heading = sine_cosine(walker.heading);
  const SineCosine goal = sine_cosine(wrapped(persons.goal_direction[i]));
  who.velocity = Vec2(persons.vx[i], persons.vy[i]);
  who.heading = Vec2(heading.cos, heading.sin);
  who.goal_direction = Vec2(goal.cos, goal.sin);
  who.goal_distance = persons.goal_distance[i];
  who.speed = persons.preferred_speed[i];
  who.caution = snapshot_.attention ? snapshot_.attention->persons[i].caution : 1.0;
  who.step = snapshot_.step;
  who.time = snapshot_.time;
  who.key = persons.key[i];
  who.seed = snapshot_.seed;
  who.parameters = snapshot_.parameters;
  see_persons(i, false, walker, senses, who);
  see_walls(walker, who);
  notice_vehicles(i, walker, senses, who);
}

void PerceivingModel::see_persons(std::size_t i, bool turned, const Walker& walker,
                                  const Senses& senses, Perceived& who) const {
  static thread_local std::vector<SlotGroup> space;
  who.neighbours.clear();
  const Persons& persons = *snapshot_.persons;
  who.radius = turned ? persons.turned_radius[i] : persons.present_radius[i];
  who.width = who.radius / persons.radius[i];
  const PersonSlots slots = scenery_.persons().slots();
  const float* const radii = turned ? slots.turned_radius : slots.present_radius;
  const double reach = std::min(reach_, static_cast<double>(senses.sight));
  const double field = senses.field_cos;
  for (const SlotGroup& group : scenery_.persons().groups(walker.at, walker.heading, space)) {
    for (std::uint32_t lane = 0; lane < kSlotGroup; ++lane) {
      if ((group.used >> lane & 1U) == 0) continue;
      const std::uint32_t j = group.first + lane;
      const Vec2 offset = offset_to({slots.x[j], slots.y[j]}, walker.at);
      const double distance = offset.norm();
      if (distance == 0.0 || distance > reach) continue;  // at 0: itself
      if (offset.dot(who.heading) < field * distance) continue;
      const double radius = radii[j];
      const bool stands = slots.speed2[j] < kStaticSpeed * kStaticSpeed;
      if (stands && distance > walker.static_reach + who.radius + radius) continue;
      who.neighbours.push_back({offset, Vec2(slots.vx[j], slots.vy[j]), radius, distance});
    }
  }
  sort(who.neighbours);
}

void PerceivingModel::see_walls(const Walker& walker, Perceived& who) const {
  who.borders.clear();
  const double reach = walker.static_reach + who.radius;
  for (const std::uint32_t w : scenery_.walls().near(walker.at)) {
    const WallFace& face = scenery_.walls()[w];
    Border border;
    border.a = offset_to(face.from, walker.at);
    border.b = offset_to(face.to, walker.at);
    const Vec2 along = border.b - border.a;
    if (cross(along, -border.a) < 0.0 || along.isZero()) continue;  // seen from behind
    border.nearest = nearest_on(border.a, border.b, Vec2::Zero());
    border.distance = border.nearest.norm();
    if (border.distance > reach) continue;
    border.normal = left_of(along).normalized();
    border.repeated = false;
    who.borders.push_back(border);
  }
  sort(who.borders);
  for (std::size_t k = 1; k < who.borders.size(); ++k) {
    who.borders[k].repeated = who.borders[k].nearest == who.borders[k - 1].nearest;
  }
}

void PerceivingModel::notice_vehicles(std::size_t i, const Walker& walker, const Senses& senses,
                                      Perceived& who) const {
  who.vehicles.clear();
  for (const std::uint32_t v : scenery_.vehicles_near(walker.at)) {
    if (!scenery_.minds(i, v)) continue;
    const VehicleShape& shape = scenery_.vehicles()[v];
    if (awareness(view_of(shape, walker), walker, senses) == Awareness::kNone) continue;
    const SeenVehicle vehicle = seen(shape, walker.at);
    if (!vehicle.moving && vehicle.distance > walker.static_reach + who.radius) continue;
    who.vehicles.push_back(vehicle);
  }
  sort(who.vehicles);
}

}  // namespace pedzone
