// A program of somebody else: runs a SUMO scenario with pedzone inside it for a minute.
#include <cstdio>
#include <exception>

#include "sumo/simulation.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    pedzone::SimulationOptions options;
    options.scenario = pedzone::read_scenario(argv[1], {});
    options.end = 60.0;
    pedzone::Simulation simulation(options);
    while (!simulation.finished()) simulation.step();
    const pedzone::RunSummary summary = simulation.summary();
    simulation.close();
    std::printf("%ld persons walked by pedzone, %ld lost\n", summary.persons.controlled,
                summary.persons.lost);
    return summary.persons.controlled > 0 && summary.persons.lost == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
