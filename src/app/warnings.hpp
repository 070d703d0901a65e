// What a run tells of people while it goes on.
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "app/progress.hpp"
#include "sumo/simulation.hpp"

namespace pedzone {

/// Tells of people who are stuck among people, of the first ones by name.
class JamWarnings {
 public:
  void step(const Simulation& simulation, Progress& progress);
  void finish(const Simulation& simulation, Progress& progress) const;

 private:
  std::size_t told_ = 0;
};

/// Tells whom another program moves, each once.
class OutsideNotes {
 public:
  void step(const Simulation& simulation, Progress& progress);

 private:
  std::size_t vehicles_ = 0, persons_ = 0;
  std::set<std::string> told_;
};

/// Tells once that many people have stood for long, and where most of them do.
class StuckWarning {
 public:
  void step(const Simulation& simulation, Progress& progress);

 private:
  bool told_ = false;
};

}  // namespace pedzone
