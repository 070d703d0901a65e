// Measures a run's outputs, for checks from outside: prints a line `key value` for each measure and
// `demand.KEY CHECKSUM`; or the free speed of each person.
//
// usage: measure_run FOLDER SCENARIO.sumocfg [ZONE.zone.xml]
//        measure_run --free-speed FCD [TRAJECTORIES.csv]
#include <fmt/format.h>

#include "study/measure/free_walk_measure.hpp"
#include "study/measure/run_measures.hpp"
#include "sumo/files/scenario.hpp"

namespace pedzone::study {
namespace {

void print_measures(const std::string& folder, const std::string& config,
                    const std::string& zone_file) {
  const std::vector<ZoneSpec> specs =
      zone_file.empty() ? std::vector<ZoneSpec>{} : read_zone_file(zone_file).zones;
  Place place;
  place.network = read_scenario_network(read_any_scenario(config, {}));
  place.zones = build_zones(place.network, specs);
  const RunMeasures measures = measure_run({folder, config, {}, {}}, place);
  for (const auto& [key, value] : measures.values) fmt::print("{} {}\n", key, value);
  for (const auto& [key, sum] : measures.demand) fmt::print("demand.{} {}\n", key, sum);
}

void print_free_speeds(const std::string& fcd, const std::string& trajectories) {
  for (const auto& [id, walk] : free_walks_of(fcd, trajectories)) {
    if (walk.speed) fmt::print("{} {}\n", id, *walk.speed);
  }
}

}  // namespace
}  // namespace pedzone::study

int main(int count, char** words) {
  if (count < 3) return pedzone::kExitInput;
  const std::string first = words[1], second = words[2], third = count > 3 ? words[3] : "";
  try {
    if (first == "--free-speed") {
      pedzone::study::print_free_speeds(second, third);
    } else {
      pedzone::study::print_measures(first, second, third);
    }
  } catch (const pedzone::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return pedzone::kExitInput;
  }
  return 0;
}
