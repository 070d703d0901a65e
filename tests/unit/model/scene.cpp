#include "scene.hpp"

#include <algorithm>
#include <numeric>

#include "oracle.hpp"

namespace pedzone::test {

PersonSpec walking_to(const Vec2& at, double direction) {
  PersonSpec person;
  person.at = at;
  person.heading = person.goal = direction;
  person.velocity = person.speed * unit(direction);
  return person;
}

Shuffled shuffled(const Scene& scene, std::uint32_t seed) {
  std::mt19937 random(seed);
  Shuffled other{scene, std::vector<std::size_t>(scene.people.size())};
  std::iota(other.order.begin(), other.order.end(), std::size_t{0});
  std::shuffle(other.order.begin(), other.order.end(), random);
  for (std::size_t i = 0; i < other.order.size(); ++i) {
    other.scene.people[i] = scene.people[other.order[i]];
  }
  std::shuffle(other.scene.vehicles.begin(), other.scene.vehicles.end(), random);
  return other;
}

Persons persons_of(const std::vector<PersonSpec>& people) {
  Persons p;
  for (const PersonSpec& person : people) {
    p.x.push_back(person.at.x());
    p.y.push_back(person.at.y());
    p.vx.push_back(person.velocity.x());
    p.vy.push_back(person.velocity.y());
    p.heading.push_back(wrap_angle(person.heading));
    p.radius.push_back(person.radius);
    p.turned_radius.push_back(person.turned_width * person.radius);
    p.present_radius.push_back(person.radius);
    p.preferred_speed.push_back(person.speed);
    p.goal_direction.push_back(wrap_angle(person.goal));
    p.goal_distance.push_back(person.goal_distance);
    p.key.push_back(person.key != 0 ? person.key : p.key.size());
  }
  p.walking = people.size();
  return p;
}

std::vector<Decision> Scene::decide(WalkingModel& model) const {
  const Persons persons = persons_of(people);
  const WallIndex index(walls);
  model.prepare({&persons, vehicles, &index, &parameters});
  std::vector<Decision> decisions(people.size());
  model.decide(0, people.size(), decisions);
  return decisions;
}

std::vector<Decision> Scene::decide() const { return decide(*make_model(model_name)); }

VehicleState vehicle(const Vec2& centre, double heading, double speed, double length,
                     double width) {
  VehicleState v;
  v.centre = centre;
  v.heading = heading;
  v.velocity = speed * unit(heading);
  v.length = length;
  v.width = width;
  return v;
}

Scene random_scene(const RandomScene& spec, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto number = [&](double least, double most) {
    return least + (most - least) * std::uniform_real_distribution<double>(0.0, 1.0)(random);
  };
  const double side = std::sqrt(static_cast<double>(spec.people) / spec.density);
  const auto place = [&]() -> Vec2 {
    const double x = number(0.0, side), y = number(0.0, side);
    return spec.origin + Vec2(x, y);
  };
  Scene scene;
  for (std::size_t i = 0; i < spec.people; ++i) {
    PersonSpec p;
    p.at = place();
    p.heading = number(-kPi, kPi);
    const double speed = number(0.0, 1.0) < 0.2 ? 0.0 : number(0.0, 2.0);
    p.velocity = speed * unit(p.heading + number(-0.5, 0.5));
    p.radius = number(0.15, 0.4);
    p.speed = number(0.6, 1.9);
    p.goal = p.heading + (number(0.0, 1.0) < 0.2 ? number(-kPi, kPi) : number(-0.6, 0.6));
    p.goal_distance = number(0.0, 1.0) < 0.3 ? number(0.1, 8.0) : 60.0;
    scene.people.push_back(p);
  }
  for (std::size_t i = 0; i < spec.vehicles; ++i) {
    const double speed = number(0.0, 1.0) < 0.3 ? 0.0 : number(-1.0, 6.0);
    scene.vehicles.push_back(
        vehicle(place(), number(-kPi, kPi), speed, number(2.0, 12.0), number(0.8, 2.6)));
  }
  for (std::size_t i = 0; i < spec.obstacles; ++i) {
    const Vec2 corner = place(), along = number(0.5, 5.0) * unit(number(-kPi, kPi));
    const Vec2 c[] = {corner, corner + left_of(along), corner + along + left_of(along),
                      corner + along};
    for (int j = 0; j < 4; ++j) scene.walls.push_back({c[j], c[(j + 1) % 4]});
  }
  for (PersonSpec& p : scene.people) p.turned_width = number(0.45, 1.0);
  return scene;
}

Walkthrough::Walkthrough(const Scene& scene, std::vector<Vec2> goals)
    : scene_(scene),
      goals_(std::move(goals)),
      decisions_(scene.people.size()),
      model_(make_model(scene.model_name)),
      walls_(scene.walls) {}

double Walkthrough::clearance(std::size_t person) const {
  double least = 1e9;
  for (const VehicleState& v : scene_.vehicles) {
    least = std::min(least, distance_to(v, at(person)) - scene_.people[person].radius);
  }
  return least;
}

void Walkthrough::step(double dt) {
  for (std::size_t i = 0; i < goals_.size(); ++i) {
    const Vec2 way = goals_[i] - at(i);
    scene_.people[i].goal = angle_of(way);
    scene_.people[i].goal_distance = way.norm();
  }
  const Persons persons = persons_of(scene_.people);
  model_->prepare({&persons, scene_.vehicles, &walls_, &scene_.parameters, nullptr, 0, dt});
  model_->decide(0, decisions_.size(), decisions_);
  const double share = model_->sets_velocity() ? 1.0 : dt / scene_.parameters.relaxation_time;
  for (std::size_t i = 0; i < goals_.size(); ++i) {
    PersonSpec& p = scene_.people[i];
    p.velocity += share * (decisions_[i].speed * unit(decisions_[i].direction) - p.velocity);
    p.at += dt * p.velocity;
    p.heading = decisions_[i].direction;
  }
  for (VehicleState& v : scene_.vehicles) v.centre += dt * v.velocity;
  time_ += dt;
  for (std::size_t i = 0; i < goals_.size(); ++i) {
    least_clearance_ = std::min(least_clearance_, clearance(i));
  }
}

}  // namespace pedzone::test
