#include "two_way_corridor.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace pedzone::test {
namespace {

constexpr double kStep = 0.1;    // [s]
constexpr double kMargin = 0.5;  // [m] from the corridor's ends to where people leave and enter
constexpr double kBeside = 0.5;  // [m]
constexpr double kSpeed = 1.34, kSpeedDeviation = 0.26;  // [m/s] of the paper
constexpr double kContact = 0.01;                        // [m]

Zone corridor(const CorridorSpec& spec) {
  Zone zone = zone_of(box(0, 0, spec.length, spec.width), {}, true);
  zone.model = spec.model;
  zone.parameters.field_of_view = spec.field_of_view;
  return zone;
}

}  // namespace

TwoWayCorridor::TwoWayCorridor(const CorridorSpec& spec)
    : spec_(spec), zone_(corridor(spec)), crowd_(zone_, spec.seed) {
  std::mt19937_64 random(spec.seed);
  std::uniform_real_distribution<double> along(kMargin, spec.length - kMargin);
  std::uniform_real_distribution<double> across(kMargin, spec.width - kMargin);
  std::normal_distribution<double> speed(kSpeed, kSpeedDeviation);
  for (int k = 0; k < 2 * spec.each_way; ++k) {
    Walker walker{0, {}, spec.both_ways && k % 2 != 0 ? -1.0 : 1.0, 0.0, Vec2::Zero()};
    walker.given.key = static_cast<std::uint64_t>(k) + 1;
    walker.given.place_freely = true;
    const Vec2 at(along(random), across(random));
    walker.given.preferred_speed = std::clamp(speed(random), 0.5, 2.2);
    const Vec2 velocity(walker.way * walker.given.preferred_speed, 0.0);
    walker.handle = crowd_.add(entering(walker, at, velocity));
    walker.at = crowd_.view(walker.handle).position;
    walkers_.push_back(walker);
  }
}

NewPerson TwoWayCorridor::entering(const Walker& walker, const Vec2& at,
                                   const Vec2& velocity) const {
  NewPerson person = walker.given;
  person.position = at;
  person.velocity = velocity;
  person.heading = angle_of(Vec2(walker.way, 0.0));
  // Beyond where it is taken away, so that nobody slows down before that.
  person.destination = line_at_x(walker.way > 0.0 ? spec_.length : 0.0, 0.0, spec_.width);
  return person;
}

void TwoWayCorridor::step() {
  crowd_.step(kStep, {});
  time_ += kStep;
  for (Walker& walker : walkers_) {
    const PersonView view = crowd_.view(walker.handle);
    walker.gone += walker.way * (view.position.x() - walker.at.x());
    walker.at = view.position;
    const double end = walker.way > 0.0 ? spec_.length - kMargin : kMargin;
    if (walker.way * (walker.at.x() - end) < 0.0) continue;
    crowd_.remove(walker.handle);
    walker.handle =
        crowd_.add(entering(walker, Vec2(spec_.length - end, walker.at.y()), view.velocity));
    walker.at = crowd_.view(walker.handle).position;
  }
}

void TwoWayCorridor::run(double seconds) {
  for (const double end = time_ + seconds; time_ < end - kStep / 2.0;) step();
}

double TwoWayCorridor::lane_order(const std::vector<double>& ways) const {
  double sum = 0.0;
  int counted = 0;
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    int beside = 0, balance = 0;
    for (std::size_t j = 0; j < walkers_.size(); ++j) {
      if (i == j || std::abs(walkers_[i].at.y() - walkers_[j].at.y()) > kBeside) continue;
      ++beside;
      balance += ways[i] == ways[j] ? 1 : -1;
    }
    if (beside == 0) continue;
    sum += static_cast<double>(balance * balance) / (beside * beside);
    ++counted;
  }
  return sum / counted;
}

double TwoWayCorridor::lane_order() const {
  std::vector<double> ways;
  for (const Walker& walker : walkers_) ways.push_back(walker.way);
  return lane_order(ways);
}

double TwoWayCorridor::lane_order_by_chance() const {
  constexpr int kShuffles = 50;
  std::vector<double> ways;
  for (const Walker& walker : walkers_) ways.push_back(walker.way);
  std::mt19937_64 random(1);
  double sum = 0.0;
  for (int k = 0; k < kShuffles; ++k) {
    std::shuffle(ways.begin(), ways.end(), random);
    sum += lane_order(ways);
  }
  return sum / kShuffles;
}

double TwoWayCorridor::efficiency() {
  double gone = 0.0, wanted = 0.0;
  for (Walker& walker : walkers_) {
    gone += walker.gone;
    wanted += walker.given.preferred_speed * (time_ - since_);
    walker.gone = 0.0;
  }
  since_ = time_;
  return gone / wanted;
}

int TwoWayCorridor::contacts() const {
  int contacts = 0;
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double reach = walkers_[i].given.radius + walkers_[j].given.radius;
      if ((walkers_[i].at - walkers_[j].at).norm() < reach - kContact) ++contacts;
    }
  }
  return contacts;
}

}  // namespace pedzone::test
