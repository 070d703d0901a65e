#include "study/measure/pedestrians.hpp"

#include "core/error.hpp"

namespace pedzone::study {

Pedestrians::Pedestrians(const Trips& trips) : trips_(trips), stage_(trips.persons.size(), 0) {
  for (std::uint32_t i = 0; i < trips.persons.size(); ++i) index_[trips.persons[i].id] = i;
}

std::span<const Pedestrian> Pedestrians::at(double time, std::span<const PersonSample> persons) {
  pedestrians_.clear();
  for (const PersonSample& sample : persons) {
    if (!sample.rides_in.empty()) continue;
    const auto found = index_.find(sample.id);
    if (found == index_.end()) {
      throw InputError("is in the floating-car data but not in the tripinfo",
                       {.element = "person",
                        .value = std::string(sample.id),
                        .allowed = "outputs of one run, with tripinfo-output.write-unfinished"});
    }
    const std::uint32_t person = found->second;
    pedestrians_.push_back(
        {person, walk_of(person, time), sample.position, sample.velocity.norm(), sample.edge});
  }
  return pedestrians_;
}

const WalkStage* Pedestrians::walk_of(std::uint32_t person, double time) {
  const std::vector<WalkStage>& walks = trips_.persons[person].walks;
  std::uint32_t& stage = stage_[person];
  while (stage < walks.size() && walks[stage].arrival && *walks[stage].arrival < time) ++stage;
  return stage < walks.size() && walks[stage].depart <= time ? &walks[stage] : nullptr;
}

}  // namespace pedzone::study
