// What one person and step of the walking model cost, on one thread:
//   kernel_benchmark --benchmark_repetitions=7 --benchmark_report_aggregates_only
// The column per_person [s] counts everything a step needs, the sorting of persons included. The
// scene: people on a square, walking in all directions, sight 10 m, 61 directions in ±75°, for
// each 10,000 m² 50 square obstacles (200 walls) and 20 vehicles of up to 3 m/s.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>

#include "model/heuristic_model.hpp"
#include "oracle.hpp"
#include "scene.hpp"
#include "world/model_names.hpp"

namespace pedzone::test {
namespace {

constexpr double kAreaPerObstacle = 200.0, kAreaPerVehicle = 500.0;  // [m²]
constexpr std::uint32_t kSeed = 42;

/// `people` that decide, and a margin as wide as they see of people who only stand there to be
/// seen: without it a small square would be cheap for having a border. They stand one in a square
/// cell each, off its middle by up to a quarter of its side, so that nobody overlaps at 1 /m²;
/// cells with a vehicle or an obstacle stay empty.
struct CrowdedSquare {
  Scene scene;  ///< those that decide come first
  std::size_t deciding = 0;
};

CrowdedSquare crowded_square(std::size_t people, double density) {
  std::mt19937 random(kSeed);
  const auto number = [&](double least, double most) {
    return least + (most - least) * std::uniform_real_distribution<double>(0.0, 1.0)(random);
  };
  const double cell = 1.0 / std::sqrt(density), margin = Parameters().sight;
  const double inner = std::sqrt(static_cast<double>(people) / density);
  const double side = inner + 2.0 * margin, area = side * side;
  const Vec2 origin(7000.0, 7000.0);
  const auto place = [&]() -> Vec2 {
    const double x = number(0.0, side), y = number(0.0, side);
    return origin + Vec2(x, y);
  };
  Scene scene;
  for (int i = 0; i < static_cast<int>(area / kAreaPerVehicle); ++i) {
    scene.vehicles.push_back(vehicle(place(), number(-kPi, kPi), number(0.0, 3.0)));
  }
  for (int i = 0; i < static_cast<int>(area / kAreaPerObstacle); ++i) {
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
  std::normal_distribution<double> speeds(1.34, 0.26);  // Weidmann 1993
  std::vector<PersonSpec> outer;
  const int columns = static_cast<int>(side / cell);
  for (int row = 0; row < columns; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x = cell * (column + number(0.25, 0.75));
      const double y = cell * (row + number(0.25, 0.75));
      PersonSpec p;
      p.at = origin + Vec2(x, y);
      p.heading = number(-kPi, kPi);
      p.speed = std::clamp(speeds(random), 0.5, 2.2);
      p.velocity = number(0.2, 1.0) * p.speed * unit(p.heading);
      p.goal = p.heading + number(-0.5, 0.5);
      if (blocked(p.at)) continue;
      const bool inside =
          std::max(std::abs(x - side / 2.0), std::abs(y - side / 2.0)) < inner / 2.0;
      (inside ? scene.people : outer).push_back(p);
    }
  }
  const std::size_t deciding = scene.people.size();
  scene.people.insert(scene.people.end(), outer.begin(), outer.end());
  return {std::move(scene), deciding};
}

void step(benchmark::State& state, WalkingModel& model, std::size_t people, double density) {
  const auto [scene, deciding] = crowded_square(people, density);
  Persons persons = persons_of(scene.people);
  persons.walking = deciding;
  const WallIndex walls(scene.walls);
  std::vector<Decision> decisions(persons.size());
  for (auto _ : state) {
    model.prepare({&persons, scene.vehicles, &walls, &scene.parameters});
    model.decide(0, deciding, decisions);
    benchmark::DoNotOptimize(decisions.data());
  }
  state.counters["per_person"] = benchmark::Counter(
      static_cast<double>(deciding),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// About `range(0)` people at `range(1)` per 10 m².
void step(benchmark::State& state, const DirectionKernel& kernel,
          VehicleForm form = VehicleForm::kDiscomfort) {
  HeuristicModel model(form, kernel);
  step(state, model, static_cast<std::size_t>(state.range(0)),
       static_cast<double>(state.range(1)) / 10.0);
}

void step_avx2(benchmark::State& state) {
  if (!has_avx2()) {
    state.SkipWithError("this processor has no AVX2");
    return;
  }
  step(state, avx2_kernel());
}

/// Vehicles as in the paper: what the discomfort costs is the difference.
void step_plain(benchmark::State& state) { step(state, fastest_kernel(), VehicleForm::kPlain); }

void step_baseline(benchmark::State& state) { step(state, baseline_kernel()); }

void cases(benchmark::internal::Benchmark* b) {
  b->ArgNames({"people", "per_10_m2"})->Unit(benchmark::kMillisecond);
  for (const int density : {5, 10, 20}) b->Args({10000, density});
  for (const int people : {1000, 2000, 5000, 20000, 50000}) b->Args({people, 10});
}

BENCHMARK(step_avx2)->Apply(cases);
BENCHMARK(step_plain)->Apply(cases);
BENCHMARK(step_baseline)->Apply(cases);

/// Every model at 1 /m².
const bool kModelsAdded = [] {
  for (const std::string_view name : kModelNames) {
    for (const std::size_t people : {1000U, 10000U}) {
      const std::string title = "step_model/" + std::string(name) + "/" + std::to_string(people);
      benchmark::RegisterBenchmark(title.c_str(), [=](benchmark::State& state) {
        step(state, *make_model(std::string(name)), people, 1.0);
      })->Unit(benchmark::kMillisecond);
    }
  }
  return true;
}();

}  // namespace
}  // namespace pedzone::test
