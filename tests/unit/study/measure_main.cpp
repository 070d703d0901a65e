// Measures a run's outputs, for checks from outside: prints a line `key value` for each measure and
// `demand.KEY CHECKSUM`.
//
// usage: measure_run FOLDER SCENARIO.sumocfg [ZONE.zone.xml]
#include <fmt/format.h>

#include "study/run_measures.hpp"
#include "sumo/scenario.hpp"

int main(int count, char** words) {
  using namespace pedzone;
  if (count < 3) return kExitInput;
  try {
    const std::vector<ZoneSpec> specs =
        count > 3 ? read_zone_file(words[3]).zones : std::vector<ZoneSpec>{};
    Place place;
    place.network = read_scenario_network(read_any_scenario(words[2], {}));
    place.zones = build_zones(place.network, specs);
    const RunMeasures measures = measure_run({words[1], words[2], {}, {}}, place);
    for (const auto& [key, value] : measures.values) fmt::print("{} {}\n", key, value);
    for (const auto& [key, sum] : measures.demand) fmt::print("demand.{} {}\n", key, sum);
  } catch (const InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return kExitInput;
  }
  return 0;
}
