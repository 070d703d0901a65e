#include "oracle.hpp"

#include <algorithm>

namespace pedzone::test {

double distance_to(const VehicleState& vehicle, const Vec2& point) {
  const Vec2 ahead = unit(vehicle.heading), d = point - vehicle.centre;
  const double x = std::max(std::abs(d.dot(ahead)) - vehicle.length / 2.0, 0.0);
  const double y = std::max(std::abs(cross(ahead, d)) - vehicle.width / 2.0, 0.0);
  return std::hypot(x, y);
}

double distance_to(const Wall& wall, const Vec2& point) {
  const Vec2 along = wall.b - wall.a;
  const double s = std::clamp((point - wall.a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (wall.a + s * along - point).norm();
}

double Obstacle::distance(const Vec2& point, double time) const {
  switch (kind) {
    case Kind::kDisc:
      return (at + time * velocity - point).norm();
    case Kind::kVehicle:
      return distance_to(vehicle, point - time * vehicle.velocity);
    default:
      return distance_to(wall, point);
  }
}

Obstacle disc(const Vec2& at, const Vec2& velocity, double contact) {
  Obstacle o;
  o.kind = Obstacle::Kind::kDisc;
  o.at = at;
  o.velocity = velocity;
  o.contact = contact;
  return o;
}

Obstacle rectangle(const VehicleState& vehicle, double contact) {
  Obstacle o;
  o.kind = Obstacle::Kind::kVehicle;
  o.vehicle = vehicle;
  o.contact = contact;
  return o;
}

Obstacle segment(const Wall& wall, double contact) {
  Obstacle o;
  o.kind = Obstacle::Kind::kWall;
  o.wall = wall;
  o.contact = contact;
  return o;
}

double Obstacle::speed() const {
  switch (kind) {
    case Kind::kDisc:
      return velocity.norm();
    case Kind::kVehicle:
      return vehicle.velocity.norm();
    default:
      return 0.0;
  }
}

double time_to_contact(const Obstacle& obstacle, const Vec2& from, const Vec2& velocity,
                       double horizon) {
  const double closing = velocity.norm() + obstacle.speed();
  double t = 0.0;
  while (t < horizon) {
    const double gap = obstacle.distance(from + t * velocity, t) - obstacle.contact;
    if (gap < 0.0) return t;
    t += std::max(kOracleStep, gap / closing);  // nothing can happen sooner
  }
  return horizon;
}

std::vector<double> main_offsets() {
  std::vector<double> offsets;
  for (int k = -30; k <= 30; ++k) offsets.push_back(k * 2.5 * kPi / 180.0);
  return offsets;
}

std::vector<double> rest_offsets() {
  std::vector<double> offsets;
  for (int degrees = 80; degrees < 180; degrees += 5) {
    offsets.push_back(-degrees * kPi / 180.0);
    offsets.push_back(degrees * kPi / 180.0);
  }
  offsets.push_back(kPi);
  return offsets;
}

double value(int equation, double free, double sight, double from_goal) {
  return free * free - 2.0 * sight * free * std::cos(wrap_angle(from_goal) / equation);
}

double contact_distance(const PersonSpec& a, const PersonSpec& b, Width width) {
  const double full = a.radius + b.radius;
  const double turned = a.turned_width * a.radius + b.turned_width * b.radius;
  switch (width) {
    case Width::kFull:
      return full;
    case Width::kTurned:
      return turned;
    default: {  // as a queue demands behind who walks ahead, for feet no broader than SUMO's person
      const double feet = std::min(a.radius, 0.239) + std::min(b.radius, 0.239);
      const double root = 0.6 + 0.38 * std::cos(a.heading - b.heading);
      return std::max(turned, turned + root * root * (feet - turned));
    }
  }
}

int equation_of(const Scene& scene) {
  const bool minds_vehicles = scene.model_name == "heuristic" && scene.parameters.discomfort > 0.0;
  if (minds_vehicles || scene.model_name == "heuristic-original") return 1;
  return static_cast<int>(scene.parameters.equation);
}

std::vector<Obstacle> aware_of(const Scene& scene, std::size_t person, Width width) {
  const Parameters& p = scene.parameters;
  const PersonSpec& self = scene.people[person];
  const double half_field = p.field_of_view * kPi / 180.0;
  const auto in_view = [&](const Vec2& point) {
    const Vec2 d = point - self.at;
    return std::abs(wrap_angle(angle_of(d) - self.heading)) <= half_field;
  };
  std::vector<Obstacle> obstacles;
  for (std::size_t j = 0; j < scene.people.size(); ++j) {
    const PersonSpec& other = scene.people[j];
    if (j == person || (other.at - self.at).norm() > p.sight || !in_view(other.at)) continue;
    obstacles.push_back(disc(other.at, other.velocity, contact_distance(self, other, width)));
  }
  for (const VehicleState& v : scene.vehicles) {
    const bool parked = v.velocity.norm() < 0.05;
    const double distance = distance_to(v, self.at);
    bool seen = false;  // some point of the rectangle, on a grid of 101 × 101
    for (int i = 0; i <= 100 && !seen; ++i) {
      for (int j = 0; j <= 100 && !seen; ++j) {
        const Vec2 ahead = unit(v.heading);
        seen = in_view(v.centre + (i / 100.0 - 0.5) * v.length * ahead +
                       (j / 100.0 - 0.5) * v.width * left_of(ahead));
      }
    }
    const bool aware = distance <= p.sight && (parked || seen);
    const bool heard = !parked && distance <= p.hearing;
    const double room = std::min(parked ? 0.1 : 0.25, (distance - self.radius) / 2.0);
    if (aware || heard) obstacles.push_back(rectangle(v, self.radius + room));
  }
  for (const Wall& wall : scene.walls) {
    const bool in_front = cross(wall.b - wall.a, self.at - wall.a) >= 0.0;
    const double turned = width == Width::kFull ? 1.0 : self.turned_width;
    if (in_front) obstacles.push_back(segment(wall, turned * self.radius));
  }
  return obstacles;
}

OracleChoice best_direction(const Scene& scene, std::size_t person, bool all_directions,
                            Width width) {
  const PersonSpec& self = scene.people[person];
  const double sight = scene.parameters.sight;
  const int equation = equation_of(scene);
  const std::vector<Obstacle> obstacles = aware_of(scene, person, width);
  std::vector<double> offsets = main_offsets();
  if (all_directions) {
    const std::vector<double> rest = rest_offsets();
    offsets.insert(offsets.end(), rest.begin(), rest.end());
  }
  OracleChoice best;
  double least = 1e300, second = 1e300;
  for (const double offset : offsets) {
    double time = sight / self.speed;
    const Vec2 velocity = self.speed * unit(self.heading + offset);
    for (const Obstacle& o : obstacles) time = time_to_contact(o, self.at, velocity, time);
    const double free = time * self.speed;
    const double d = value(equation, free, sight, self.goal - self.heading - offset);
    if (d < least) {
      second = least;
      least = d;
      best = {offset, free, 0.0};
    } else {
      second = std::min(second, d);
    }
  }
  best.margin = second - least;
  return best;
}

/// [m] least way to a contact with people in any of the main directions.
static double way_to_people(const Scene& scene, std::size_t person) {
  const PersonSpec& self = scene.people[person];
  const std::vector<Obstacle> obstacles = aware_of(scene, person);
  double time = scene.parameters.sight / self.speed;
  for (const double offset : main_offsets()) {
    const Vec2 velocity = self.speed * unit(self.heading + offset);
    for (const Obstacle& o : obstacles) {
      if (o.kind == Obstacle::Kind::kDisc) time = time_to_contact(o, self.at, velocity, time);
    }
  }
  return time * self.speed;
}

OracleDecision decision_of(const Scene& scene, std::size_t person) {
  constexpr double kClose = 0.02;  // [m]
  const PersonSpec& self = scene.people[person];
  const Parameters& p = scene.parameters;
  OracleDecision decision;
  const auto less = [&](double free, double limit) {
    decision.clear = decision.clear && std::abs(free - limit) > kClose;
    return free < limit;
  };
  OracleChoice& best = decision.choice;
  best = best_direction(scene, person, false);
  const double turning = p.turn_time * self.speed;
  // Where walls alone are in the way there is nothing to be gained.
  decision.turns = less(best.free, turning) && less(way_to_people(scene, person), turning);
  const Width width = decision.turns ? Width::kTurned : Width::kFull;
  if (decision.turns) best = best_direction(scene, person, false, width);
  if (less(best.free, p.near_distance)) best = best_direction(scene, person, true, width);
  decision.free = best.free;
  if (!decision.turns) return decision;
  const Vec2 velocity = self.speed * unit(self.heading + best.offset);
  double time = best.free / self.speed;
  for (const Obstacle& o : aware_of(scene, person, Width::kByFacing)) {
    if (o.kind == Obstacle::Kind::kDisc) time = time_to_contact(o, self.at, velocity, time);
  }
  decision.free = time * self.speed;
  return decision;
}

double signed_distance_to(const VehicleState& vehicle, const Vec2& point) {
  const double outside = distance_to(vehicle, point);
  if (outside > 0.0) return outside;
  const Vec2 ahead = unit(vehicle.heading), d = point - vehicle.centre;
  return std::max(std::abs(d.dot(ahead)) - vehicle.length / 2.0,
                  std::abs(cross(ahead, d)) - vehicle.width / 2.0);
}

Stride stride(const Vec2& at, const Vec2& now, const Vec2& wanted, double lag, double stop) {
  return {at + lag * (now - wanted), wanted, stop};
}

double least_clearance(const VehicleState& vehicle, const Stride& stride, double horizon,
                       int samples) {
  const auto clearance = [&](double t) {
    return signed_distance_to(vehicle, stride.at(t) - t * vehicle.velocity);
  };
  double best = 0.0, least = clearance(0.0);
  const auto look_at = [&](double t) {
    const double c = clearance(t);
    if (c >= least) return;
    best = t;
    least = c;
  };
  const double apart = horizon / samples;
  for (int i = 1; i <= samples; ++i) look_at(i * apart);
  look_at(std::clamp(stride.stop, 0.0, horizon));
  const double middle = best;
  for (int i = -50; i <= 50; ++i) {
    look_at(std::clamp(middle + i * apart / 50.0, 0.0, horizon));
  }
  return least;
}

Bounds discomfort(double clearance, double margin) {
  constexpr double kUnsure = 1e-4;
  const auto h = [&](double c, double depth_share) {
    if (c >= margin) return 0.0;
    return c > 0.0 ? (1.0 - c / margin) * (1.0 - c / margin)
                   : 1.0 - depth_share * c / (2.0 * margin);
  };
  return {h(clearance + kUnsure, 0.5), h(clearance - kUnsure, 1.0)};
}

/// Soonest and latest time [s] of a contact with obstacles of a kind, as grazes count or not.
static Bounds contact_with(const std::vector<Obstacle>& around, Obstacle::Kind kind,
                           const PersonSpec& self, double heading, double horizon) {
  constexpr double kGraze = 2e-3;  // [m]
  Bounds times{horizon, horizon};
  for (Obstacle o : around) {
    if (o.kind != kind) continue;
    const double contact = o.contact;
    const Vec2 velocity = self.speed * unit(heading);
    o.contact = contact + kGraze;
    times.least = std::min(times.least, time_to_contact(o, self.at, velocity, horizon));
    o.contact = contact - kGraze;
    times.most = std::min(times.most, time_to_contact(o, self.at, velocity, horizon));
  }
  return times;
}

Bounds total_value(const Scene& scene, const std::vector<Obstacle>& around, double offset,
                   double share, double caution) {
  constexpr double kFullMarginSpeed = 0.5;  // [m/s]
  const Parameters& p = scene.parameters;
  const PersonSpec& self = scene.people[0];
  const double heading = self.heading + offset, horizon = p.sight / self.speed;
  const Bounds wall = contact_with(around, Obstacle::Kind::kWall, self, heading, horizon);
  const Bounds vehicle = contact_with(around, Obstacle::Kind::kVehicle, self, heading, horizon);
  Bounds worst;
  for (const Obstacle& o : around) {
    if (o.kind != Obstacle::Kind::kVehicle) continue;
    const double v = o.speed();
    const double along = o.vehicle.velocity.normalized().dot(unit(self.heading));
    const double margin = (p.discomfort_margin + p.discomfort_margin_time * v) *
                          (1.0 + p.room_behind * std::max(0.0, along)) * caution *
                          std::min(1.0, v / kFullMarginSpeed);
    const auto h = [&](double stop) {
      const Stride way = stride(self.at, self.velocity, share * self.speed * unit(heading),
                                p.relaxation_time, share > 0.0 ? stop / share : 1e9);
      return discomfort(least_clearance(o.vehicle, way, p.discomfort_horizon, 400), margin);
    };
    const Bounds soon = h(wall.least), late = wall.most > wall.least ? h(wall.most) : soon;
    worst = {std::max(worst.least, std::min(soon.least, late.least)),
             std::max({worst.most, soon.most, late.most})};
  }
  const double unit2 = p.sight * p.sight;
  const double weight = share > 1.0 ? p.hurry_cost : p.slowing_cost;
  const double slow = unit2 * weight * (1.0 - share) * (1.0 - share);
  // d falls until f is at its lowest point, then rises.
  const double from_goal = wrap_angle(self.goal - heading);
  const auto d = [&](double f) {
    return value(static_cast<int>(p.equation), f, p.sight, from_goal);
  };
  const double nearest = std::min(wall.least, vehicle.least) * self.speed;
  const double farthest = std::min(wall.most, vehicle.most) * self.speed;
  const double lowest = std::clamp(p.sight * std::cos(from_goal / p.equation), nearest, farthest);
  return {d(lowest) + unit2 * p.discomfort * worst.least + slow,
          std::max(d(nearest), d(farthest)) + unit2 * p.discomfort * worst.most + slow};
}

}  // namespace pedzone::test
