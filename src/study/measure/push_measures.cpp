#include "study/measure/push_measures.hpp"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace pedzone::study {

void measure_pushes(const std::string& folder, std::map<std::string, double>& values) {
  double persons = 0.0, way = 0.0, speed = 0.0, run_into = 0.0;
  const std::string path = folder + "/summary.json";
  if (std::filesystem::exists(path)) {
    std::ifstream stream(path);
    try {
      const auto json = nlohmann::json::parse(stream);
      const auto& pushes = json.at("pushes");
      persons = pushes.at("persons").get<double>();
      way = pushes.at("longest_m").get<double>();
      speed = pushes.at("fastest_mps").get<double>();
      run_into = static_cast<double>(json.at("run_into").get<nlohmann::json::array_t>().size());
    } catch (const nlohmann::json::exception&) {
      throw InputError("is not a summary with pushes",
                       {path, 0, "", "", "what pedzone run writes"});
    }
  }
  values["conflict.pushed"] = persons;
  values["conflict.pushWay"] = way;
  values["conflict.pushSpeed"] = speed;
  values["conflict.runInto"] = run_into;
}

}  // namespace pedzone::study
