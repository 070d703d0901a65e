// The runs that a study's directory is to hold.
//   planned_runs RESULTS
// Prints a JSON array of their ids and definitions.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "study/run/store.hpp"

int main(int count, char** words) {
  if (count != 2) return 2;
  nlohmann::ordered_json runs = nlohmann::ordered_json::array();
  for (const pedzone::study::PlannedRun& run : pedzone::study::Store::open(words[1]).plan().runs) {
    runs.push_back({{"id", run.id}, {"definition", run.definition}});
  }
  std::puts(runs.dump().c_str());
  return 0;
}
