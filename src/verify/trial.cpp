#include "verify/trial.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace pedzone::verify {
namespace {

constexpr double kLeastSpeed = 0.5, kMostSpeed = 2.2;  // [m/s] assumed

Zone changed(Zone zone, const std::function<void(Zone&)>& change) {
  if (change) change(zone);
  return zone;
}

}  // namespace

Trial::Trial(const Region& walkable, const RunInput& input,
             const std::function<void(Zone&)>& change)
    : zone_(changed(zone_of(walkable, input.model), change)),
      crowd_(zone_, input.seed),
      seed_(input.seed) {}

std::size_t Trial::add(const Vec2& at, const Destination& to, int stream,
                       std::optional<double> speed, double start) {
  NewPerson person;
  person.position = at;
  person.destination = to;
  person.preferred_speed = speed ? *speed : drawn_speed(seed_, people_.size() + 1);
  person.heading = angle_of(0.5 * (to.a + to.b) - at);
  person.velocity = start * person.preferred_speed * unit(person.heading);
  return add(person, stream);
}

std::size_t Trial::add(NewPerson person, int stream) {
  person.key = people_.size() + 1;
  person.radius = kBodyRadius;
  Participant participant;
  participant.given = person;
  participant.stream = stream;
  participant.handle = crowd_.add(person);
  participant.at = participant.before = crowd_.view(participant.handle).position;
  people_.push_back(participant);
  return people_.size() - 1;
}

void Trial::step() {
  if (period_) see_beyond_ends();
  crowd_.step(kStep, {});
  time_ = static_cast<double>(++steps_) * kStep;
  for (Participant& participant : people_) {
    if (!participant.here) continue;
    const PersonView view = crowd_.view(participant.handle);
    participant.before = participant.at;
    participant.at = view.position;
    participant.moved += participant.at - participant.before;
    if (!zone_.walls.inside(participant.at)) ++outside_;
    if (period_) {
      carry_over(participant);
    } else if (view.gave_up) {
      crowd_.set_destination(participant.handle, participant.given.destination);
    } else if (view.arrived) {
      crowd_.remove(participant.handle);
      participant.here = false;
      participant.arrival = time_;
      ++arrived_;
    }
  }
}

void Trial::see_beyond_ends() {
  beyond_.clear();
  for (const Participant& participant : people_) {
    const Vec2 velocity = crowd_.view(participant.handle).velocity;
    const Vec2 shift(period_->length(), 0.0);
    if (participant.at.x() < period_->low + Period::kBeyond) {
      beyond_.push_back({participant.at + shift, velocity, kBodyRadius});
    }
    if (participant.at.x() > period_->high - Period::kBeyond) {
      beyond_.push_back({participant.at - shift, velocity, kBodyRadius});
    }
  }
  crowd_.see(beyond_);
}

void Trial::carry_over(Participant& participant) {
  const bool over = participant.at.x() >= period_->high, under = participant.at.x() < period_->low;
  if (!over && !under) return;
  const PersonView view = crowd_.view(participant.handle);
  const Vec2 shift((over ? -1.0 : 1.0) * period_->length(), 0.0);
  NewPerson person = participant.given;
  person.position = view.position + shift;
  person.velocity = view.velocity;
  person.heading = view.heading;
  crowd_.remove(participant.handle);
  participant.handle = crowd_.add(person);
  participant.at = crowd_.view(participant.handle).position;
  participant.before += shift;
}

void Trial::walk(double until, const std::function<void()>& look) {
  while (time_ < until - kStep / 2.0 && (people_.empty() || arrived_ < people_.size())) {
    step();
    if (look) look();
  }
}

bool Trial::at_every(double every) const {
  return steps_ % static_cast<std::uint64_t>(std::lround(every / kStep)) == 0;
}

double Trial::last_arrival(double until, int stream) const {
  double last = 0.0;
  for (const Participant& participant : people_) {
    if (stream >= 0 && participant.stream != stream) continue;
    last = std::max(last, participant.here ? until : participant.arrival);
  }
  return last;
}

double drawn_speed(std::uint64_t seed, std::uint64_t person) {
  for (std::uint64_t draw = 0;; ++draw) {
    const double speed =
        kMeanSpeed + kSpeedSpread * random_normal(seed, person, draw, Purpose::kDemand);
    if (speed >= kLeastSpeed && speed <= kMostSpeed) return speed;
  }
}

Destination line_at_x(double x, double y0, double y1) { return {{x, y0}, {x, y1}}; }
Destination line_at_y(double y, double x0, double x1) { return {{x0, y}, {x1, y}}; }

}  // namespace pedzone::verify
