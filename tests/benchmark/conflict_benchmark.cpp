// What the conflict measures cost per person and step, on one thread:
//   conflict_benchmark --benchmark_repetitions=7 --benchmark_report_aggregates_only
// The column per_person [s]. The scene is as crowded as the kernel benchmark's: people at 1 /m² on
// a square, walking in all directions, for each 10,000 m² 20 vehicles of up to 3 m/s; steps of 0.1
// s. All go straight and turn round at the border, through each other, so that far more pairs are
// on collision course than where people make way.
#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <vector>

#include "conflict/tracker.hpp"

namespace pedzone::test {
namespace {

constexpr double kStep = 0.1;              // [s]
constexpr double kAreaPerVehicle = 500.0;  // [m²]
constexpr int kWarmUp = 60;                // [steps] until trails are as long as they get

struct Square {
  double side;
  std::vector<std::string> ids;
  std::vector<PersonSample> persons;
  std::vector<VehicleSample> vehicles;

  explicit Square(std::size_t people) : side(std::sqrt(static_cast<double>(people))) {
    std::mt19937 random(42);
    const auto number = [&](double least, double most) {
      return std::uniform_real_distribution<double>(least, most)(random);
    };
    const auto place = [&]() -> Vec2 {
      const double x = number(0.0, side), y = number(0.0, side);
      return {x, y};
    };
    const auto cars = static_cast<std::size_t>(side * side / kAreaPerVehicle);
    for (std::size_t i = 0; i < people + cars; ++i) ids.push_back("body" + std::to_string(i));
    for (std::size_t i = 0; i < people; ++i) {
      const double heading = number(-kPi, kPi);
      const Vec2 velocity = number(0.3, 1.6) * unit(heading);
      persons.push_back({ids[i], place(), velocity, heading, 0.24, {}});
    }
    for (std::size_t i = 0; i < cars; ++i) {
      const double heading = number(-kPi, kPi);
      const Vec2 velocity = number(0.0, 3.0) * unit(heading);
      vehicles.push_back({ids[people + i], place(), heading, velocity, 5.0, 1.8});
    }
  }

  void move() {
    const auto go = [&](Vec2& at, Vec2& velocity, double& heading) {
      at += velocity * kStep;
      const bool outside = (at.array() < 0.0).any() || (at.array() > side).any();
      if (!outside || velocity.dot(at - Vec2(side / 2.0, side / 2.0)) < 0.0) return;
      velocity = -velocity;
      heading = angle_of(velocity);
    };
    for (PersonSample& person : persons) go(person.position, person.velocity, person.heading);
    for (VehicleSample& vehicle : vehicles) go(vehicle.centre, vehicle.velocity, vehicle.heading);
  }
};

void measure(benchmark::State& state) {
  const auto people = static_cast<std::size_t>(state.range(0));
  Square square(people);
  ConflictTracker tracker({});
  std::vector<Conflict> over;
  double time = 0.0;
  const auto step = [&] {
    square.move();
    tracker.step(
        time += kStep, square.persons, square.vehicles,
        [](std::size_t, std::size_t) { return std::optional(true); }, over);
    over.clear();
  };
  for (int i = 0; i < kWarmUp; ++i) step();
  for (auto _ : state) step();
  state.counters["encounters"] = static_cast<double>(tracker.encounters());
  state.counters["per_person"] = benchmark::Counter(
      static_cast<double>(people),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(measure)->ArgName("people")->Unit(benchmark::kMillisecond)->Arg(1000)->Arg(10000);

}  // namespace
}  // namespace pedzone::test
