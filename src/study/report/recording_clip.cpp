#include "study/report/recording_clip.hpp"

namespace pedzone::study {

Recording clipped(Recording recording, const Box& box) {
  for (RecordedPerson& person : recording.persons) {
    std::erase_if(person.moments,
                  [&](const PersonMoment& moment) { return !box.contains(moment.position); });
  }
  for (RecordedVehicle& vehicle : recording.vehicles) {
    std::erase_if(vehicle.moments,
                  [&](const VehicleMoment& moment) { return !box.contains(moment.centre); });
  }
  std::erase_if(recording.persons, [](const RecordedPerson& one) { return one.moments.empty(); });
  std::erase_if(recording.vehicles, [](const RecordedVehicle& one) { return one.moments.empty(); });
  return recording;
}

Recording only(Recording recording, const std::string& person, const std::string& vehicle) {
  std::erase_if(recording.persons, [&](const RecordedPerson& one) { return one.id != person; });
  std::erase_if(recording.vehicles, [&](const RecordedVehicle& one) { return one.id != vehicle; });
  return recording;
}

}  // namespace pedzone::study
