// What one person and step of the walking model cost, on one thread:
//   kernel_benchmark --benchmark_repetitions=7 --benchmark_report_aggregates_only
// The column per_person [s] counts everything a step needs, the sorting of persons included. The
// scene: people on a square, walking in all directions, sight 10 m, 61 directions in ±75°, for
// each 10,000 of them 50 square obstacles (200 walls) and 20 vehicles of up to 3 m/s.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>

#include "model/heuristic_model.hpp"
#include "oracle.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kPersonsPerObstacle = 200.0, kPersonsPerVehicle = 500.0;
constexpr std::uint32_t kSeed = 42;

/// People stand one in a square cell each, off its middle by up to a quarter of its side, so that
/// nobody overlaps at 1 /m²; cells with a vehicle or an obstacle stay empty.
Scene crowded_square(std::size_t people, double density) {
  std::mt19937 random(kSeed);
  const auto number = [&](double least, double most) {
    return least + (most - least) * std::uniform_real_distribution<double>(0.0, 1.0)(random);
  };
  const auto count = static_cast<double>(people);
  const double cell = 1.0 / std::sqrt(density), side = std::sqrt(count / density);
  const Vec2 origin(7000.0, 7000.0);
  const auto place = [&]() -> Vec2 {
    const double x = number(0.0, side), y = number(0.0, side);
    return origin + Vec2(x, y);
  };
  Scene scene;
  for (int i = 0; i < static_cast<int>(count / kPersonsPerVehicle); ++i) {
    scene.vehicles.push_back(vehicle(place(), number(-kPi, kPi), number(0.0, 3.0)));
  }
  for (int i = 0; i < static_cast<int>(count / kPersonsPerObstacle); ++i) {
    const Vec2 c = place(), along = number(1.0, 3.0) * unit(number(-kPi, kPi));
    const Vec2 corners[] = {c, c + left_of(along), c + along + left_of(along), c + along};
    for (int j = 0; j < 4; ++j) scene.walls.push_back({corners[j], corners[(j + 1) % 4]});
  }
  const auto blocked = [&](const Vec2& at) {
    const auto near_vehicle = [&](const VehicleState& v) { return distance_to(v, at) < 0.5; };
    const auto near_wall = [&](const Wall& w) { return distance_to(w, at) < 0.5; };
    return std::any_of(scene.vehicles.begin(), scene.vehicles.end(), near_vehicle) ||
           std::any_of(scene.walls.begin(), scene.walls.end(), near_wall);
  };
  const auto columns = static_cast<std::size_t>(side / cell) + 1;
  std::normal_distribution<double> speeds(1.34, 0.26);  // Weidmann 1993
  for (std::size_t c = 0; scene.people.size() < people; ++c) {
    const Vec2 middle(static_cast<double>(c % columns), static_cast<double>(c / columns));
    const double x = number(0.25, 0.75), y = number(0.25, 0.75);
    const Vec2 at = origin + cell * (middle + Vec2(x, y));
    if (blocked(at)) continue;
    PersonSpec p;
    p.at = at;
    p.heading = number(-kPi, kPi);
    p.speed = std::clamp(speeds(random), 0.5, 2.2);
    p.velocity = number(0.2, 1.0) * p.speed * unit(p.heading);
    p.goal = p.heading + number(-0.5, 0.5);
    scene.people.push_back(p);
  }
  return scene;
}

/// `range(0)` people at `range(1)` per 10 m².
void step(benchmark::State& state, const DirectionKernel& kernel) {
  const auto people = static_cast<std::size_t>(state.range(0));
  const Scene scene = crowded_square(people, static_cast<double>(state.range(1)) / 10.0);
  const Persons persons = persons_of(scene.people);
  const WallIndex walls(scene.walls);
  HeuristicModel model(kernel);
  std::vector<Decision> decisions(people);
  for (auto _ : state) {
    model.prepare({&persons, scene.vehicles, &walls, &scene.parameters});
    model.decide(0, people, decisions);
    benchmark::DoNotOptimize(decisions.data());
  }
  state.counters["per_person"] = benchmark::Counter(
      static_cast<double>(people),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void step_avx2(benchmark::State& state) {
  if (!has_avx2()) {
    state.SkipWithError("this processor has no AVX2");
    return;
  }
  step(state, avx2_kernel());
}

void step_baseline(benchmark::State& state) { step(state, baseline_kernel()); }

void cases(benchmark::internal::Benchmark* b) {
  b->ArgNames({"people", "per_10_m2"})->Unit(benchmark::kMillisecond);
  for (const int density : {5, 10, 20}) b->Args({10000, density});
  for (const int people : {1000, 2000, 5000, 20000, 50000}) b->Args({people, 10});
}

BENCHMARK(step_avx2)->Apply(cases);
BENCHMARK(step_baseline)->Apply(cases);

}  // namespace
}  // namespace pedzone::test
