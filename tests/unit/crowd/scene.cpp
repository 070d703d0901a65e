#include "scene.hpp"

#include <algorithm>
#include <cmath>

namespace pedzone::test {
namespace {

class FixedModel : public WalkingModel {
 public:
  explicit FixedModel(const Decision& decision) : decision_(decision) {}
  void prepare(const Snapshot&) override {}
  void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const override {
    std::ranges::fill(decisions.subspan(first, last - first), decision_);
  }

 private:
  Decision decision_;
};

class BlindModel : public WalkingModel {
 public:
  void prepare(const Snapshot& snapshot) override { persons_ = snapshot.persons; }
  void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const override {
    for (std::size_t i = first; i < last; ++i) {
      decisions[i] = {persons_->goal_direction[i], persons_->preferred_speed[i], 10.0, false};
    }
  }

 private:
  const Persons* persons_ = nullptr;
};

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const double squared = (b - a).squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
  return (a + t * (b - a) - p).norm();
}

}  // namespace

Ring box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Zone zone_of(const Region& space, const std::vector<Ring>& obstacles, bool noise) {
  Zone zone;
  zone.id = "test";
  zone.model = "heuristic";
  zone.walkable = space;
  for (const Ring& ring : obstacles) zone.walkable = subtract(zone.walkable, repair(ring));
  Region opaque;
  for (const Ring& ring : obstacles) opaque = unite(opaque, repair(ring));
  zone.obstacles = opaque;
  zone.walls = WallIndex(zone.walkable);
  zone.sight_walls = WallIndex(zone.obstacles);
  zone.ways = WayFinder(zone.walkable, kWayClearance);
  if (!noise) zone.parameters.heading_noise = 0.0;
  return zone;
}

Zone zone_of(const Ring& space, const std::vector<Ring>& obstacles, bool noise) {
  return zone_of(repair(space), obstacles, noise);
}

Zone with_hard_bodies(Zone zone) {
  zone.parameters.turned_width = 1.0;
  return zone;
}

std::unique_ptr<WalkingModel> blind_model() { return std::make_unique<BlindModel>(); }

std::unique_ptr<WalkingModel> fixed_model(const Decision& decision) {
  return std::make_unique<FixedModel>(decision);
}

VehicleState vehicle_at(const Vec2& centre, double heading, double speed, double length,
                        double width) {
  VehicleState vehicle;
  vehicle.centre = centre;
  vehicle.heading = heading;
  vehicle.velocity = speed * unit(heading);
  vehicle.length = length;
  vehicle.width = width;
  return vehicle;
}

double clearance(const VehicleState& vehicle, const Vec2& p) {
  const Vec2 d = p - vehicle.centre;
  const double c = std::cos(vehicle.heading), s = std::sin(vehicle.heading);
  const double ahead = std::abs(c * d.x() + s * d.y()) - 0.5 * vehicle.length;
  const double side = std::abs(c * d.y() - s * d.x()) - 0.5 * vehicle.width;
  return std::hypot(std::max(0.0, ahead), std::max(0.0, side));
}

Scene::Scene(const Zone& its_zone, std::uint64_t seed) : zone(its_zone), crowd(its_zone, seed) {}

Scene::Scene(const Zone& its_zone, std::uint64_t seed, std::unique_ptr<WalkingModel> model)
    : zone(its_zone), crowd(its_zone, seed, std::move(model)) {}

std::size_t Scene::add(NewPerson person) {
  if (person.key == 0) person.key = people.size() + 1;
  Person added;
  added.given = person;
  added.handle = crowd.add(person);
  added.view = crowd.view(added.handle);
  added.path.push_back(added.view.position);
  people.push_back(added);
  return people.size() - 1;
}

std::size_t Scene::add(const Vec2& from, const Destination& to, double preferred_speed,
                       double start) {
  NewPerson person;
  person.position = from;
  person.destination = to;
  person.preferred_speed = preferred_speed;
  const Vec2 way = 0.5 * (to.a + to.b) - from;
  person.heading = angle_of(way);
  person.velocity = start * preferred_speed * unit(person.heading);
  return add(person);
}

void Scene::step(double dt) {
  crowd.step(dt, vehicles);
  time += dt;
  for (VehicleState& vehicle : vehicles) {
    vehicle.centre += vehicle.velocity * dt;
    vehicle.heading += vehicle.yaw_rate * dt;
  }
  observe(dt);
}

void Scene::observe(double dt) {
  for (Person& person : people) {
    if (!person.here) continue;
    const Vec2 before = person.view.position;
    person.view = crowd.view(person.handle);
    const Vec2 now = person.view.position;
    const double way = (now - before).norm(), radius = person.given.radius;
    person.walked += way;
    person.path.push_back(now);
    worst_jump_ = std::max(worst_jump_, way - person.given.preferred_speed * dt);
    double gap = zone.walls.inside(now) ? 1e9 : -1.0 - radius;
    for (const Wall& wall : zone.walls.walls()) {
      if (gap < 0.0) break;
      gap = std::min(gap, distance_to_segment(now, wall.a, wall.b));
    }
    // Shoulders turn beside a wall, too.
    least_wall_gap_ = std::min(least_wall_gap_, gap - std::min(radius, person.view.radius));
    for (const VehicleState& vehicle : vehicles) {
      least_vehicle_gap_ = std::min(least_vehicle_gap_, clearance(vehicle, now) - radius);
    }
    if (!person.view.arrived) continue;
    person.arrival_time = time;
    person.here = false;
    crowd.remove(person.handle);
  }
}

void Scene::run(double until, double dt) {
  while (time < until - 1e-9 && arrived() < people.size()) step(dt);
}

std::size_t Scene::arrived() const {
  return static_cast<std::size_t>(
      std::count_if(people.begin(), people.end(), [](const Person& p) { return !p.here; }));
}

template <class Radius>
double Scene::worst_overlap_of(const Radius& radius) const {
  double worst = 0.0;
  for (std::size_t i = 0; i < people.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!people[i].here || !people[j].here) continue;
      const double distance = (people[i].view.position - people[j].view.position).norm();
      worst = std::max(worst, radius(people[i]) + radius(people[j]) - distance);
    }
  }
  return worst;
}

double Scene::worst_overlap() const {
  return worst_overlap_of([](const Person& person) { return person.given.radius; });
}

double Scene::worst_present_overlap() const {
  return worst_overlap_of([](const Person& person) { return person.view.radius; });
}

Destination line_at_x(double x, double y0, double y1) { return {{x, y0}, {x, y1}}; }
Destination line_at_y(double y, double x0, double x1) { return {{x0, y}, {x1, y}}; }
Destination point(double x, double y) { return {{x, y}, {x, y}}; }

}  // namespace pedzone::test
