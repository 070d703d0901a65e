#include "sumo/files/walked_by_pedzone.hpp"

#include <cmath>

#include "results/trajectories.hpp"

namespace pedzone {
namespace {

long long hundredths(double time) { return std::llround(time * 100.0); }

}  // namespace

void WalkedByPedzone::add(std::string_view id, double time) {
  steps_[std::string(id)].insert(hundredths(time));
}

bool WalkedByPedzone::at(std::string_view id, double time) const {
  const auto found = steps_.find(std::string(id));
  return found != steps_.end() && found->second.contains(hundredths(time));
}

std::optional<WalkedByPedzone> read_walked(const std::string& trajectories) {
  if (trajectories.empty()) return {};
  WalkedByPedzone walked;
  trajectory_table().visit(
      trajectories, [&](const TrajectoryRow& row, const CsvRow&) { walked.add(row.id, row.time); });
  return walked;
}

}  // namespace pedzone
