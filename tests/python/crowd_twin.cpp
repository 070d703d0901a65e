// The crowd of crowd_twin.py in C++: the same people, vehicles and steps. Prints how long the steps
// took [s], by the clock on the wall and by the processors', then everybody's place to the bit.
//
//   crowd_twin PEOPLE STEPS
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "crowd/crowd.hpp"
#include "verify/ground.hpp"

namespace {

using namespace pedzone;

constexpr double kSide = 60.0;  // [m]
constexpr int kVehicles = 10;

void add_people(int people, Crowd& crowd) {
  for (int k = 0; k < people; ++k) {
    NewPerson person;
    person.key = person_key("p" + std::to_string(k));
    person.position = {1.0 + 1.7 * (k % 34), 1.0 + 1.7 * (k / 34)};
    person.destination.a = person.destination.b = k % 2 == 0
                                                      ? Vec2(kSide - 1.0, 1.0 + 1.7 * (k / 34))
                                                      : Vec2(1.0 + 1.7 * (k % 34), kSide - 1.0);
    person.preferred_speed = 1.0 + 0.05 * (k % 13);
    person.heading = angle_of(person.destination.a - person.position);
    crowd.add(person);
  }
}

std::vector<VehicleState> vehicles_at(double time) {
  std::vector<VehicleState> vehicles(kVehicles);
  for (int v = 0; v < kVehicles; ++v) {
    VehicleState& vehicle = vehicles[static_cast<std::size_t>(v)];
    vehicle.key = person_key("v" + std::to_string(v));
    vehicle.heading = v % 2 == 0 ? 0.0 : kPi;
    const double way = -20.0 - 3.0 * v + 2.0 * time;
    vehicle.centre = {v % 2 == 0 ? way : kSide - way, 3.0 + 5.5 * v};
    vehicle.velocity = 2.0 * unit(vehicle.heading);
  }
  return vehicles;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const int people = std::atoi(argv[1]), steps = std::atoi(argv[2]);
  const Ring pillar = verify::box(28.0, 28.0, 32.0, 32.0);
  const Zone zone = verify::zone_of(
      subtract(repair(verify::box(0.0, 0.0, kSide, kSide)), repair(pillar)), "heuristic");
  Crowd crowd(zone, 1);
  add_people(people, crowd);
  const auto begin = std::chrono::steady_clock::now();
  const std::clock_t work_begin = std::clock();
  double sum = 0.0;  // of what a user would read after each step
  for (int step = 0; step < steps; ++step) {
    crowd.step(0.1, vehicles_at(0.1 * step));
    for (std::size_t i = 0; i < crowd.size(); ++i) {
      const PersonView view = crowd.view(crowd.handle_in(i));
      sum += view.position.x() + view.position.y();
    }
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const double work = static_cast<double>(std::clock() - work_begin) / CLOCKS_PER_SEC;
  std::printf("%.6f %.6f %.3f\n", seconds.count(), work, sum);
  for (std::size_t i = 0; i < crowd.size(); ++i) {
    std::printf("%a %a\n", crowd.persons().x[i], crowd.persons().y[i]);
  }
  return 0;
}
