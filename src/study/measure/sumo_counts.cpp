#include "study/measure/sumo_counts.hpp"

#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/xml.hpp"

namespace pedzone::study {
namespace {

constexpr NumberRange kAny{0.0, std::numeric_limits<double>::max()};

double jams_of_pedzone(const std::string& path) {
  std::ifstream stream(path);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  if (!json.is_object() || !json.contains("jams") || !json["jams"].is_array()) {
    throw InputError("is not a summary with jams", {path, 0, "", "", "what pedzone run writes"});
  }
  return static_cast<double>(json["jams"].size());
}

}  // namespace

void take_sumo_counts(const std::string& folder, std::map<std::string, double>& values) {
  const std::string statistics = folder + "/statistics.xml", summary = folder + "/summary.json";
  if (!std::filesystem::exists(statistics)) return;
  const XmlFile file(statistics, {"statistics"});
  double jams = file.number(file.root().child("persons"), "jammed", kAny, 0.0);
  if (std::filesystem::exists(summary)) jams += jams_of_pedzone(summary);
  values["person.jams"] = jams;
  values["vehicle.teleports"] = file.number(file.root().child("teleports"), "total", kAny, 0.0);
}

}  // namespace pedzone::study
