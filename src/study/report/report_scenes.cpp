#include "study/report/report.hpp"
#include "study/report/scene_parts.hpp"

namespace pedzone::study {

std::vector<ReportScene> report_scenes(const Store& store, const Plan& plan,
                                       const Records& records) {
  RunPlaces places(plan);
  std::vector<ReportScene> scenes = median_scenes(store, plan, records, places);
  for (ReportScene& scene : encounter_scenes(store, plan, records, places))
    scenes.push_back(std::move(scene));
  return scenes;
}

}  // namespace pedzone::study
