#include "study/plan/setting.hpp"

#include <algorithm>
#include <string_view>

#include "core/text.hpp"
#include "core/xml.hpp"
#include "study/plan/sumo_options.hpp"
#include "world/parameters.hpp"
#include "world/weather.hpp"
#include "zone/panel.hpp"
#include "zone/zone_file.hpp"

namespace pedzone::study {
namespace {

/// Attributes of <zone> that may vary. What walks the zone is said by the study's models.
constexpr std::string_view kZoneAttributes[] = {"edges",    "edgeTypes", "lanes",
                                                "polygons", "openSpace", "weather"};

void check_number(const std::string& value, const NumberRange& range) {
  double number = 0.0;
  if (!parse_number(value, number)) {
    throw SettingError{false, "is not a number", value, describe(range)};
  }
  if (number < range.least || number > range.most) {
    throw SettingError{false, "is out of range", value, describe(range)};
  }
}

void check_parameter(const Setting& setting) {
  const ParameterInfo* info = find_parameter(setting.key);
  if (!info) {
    throw SettingError{true, "is no parameter", setting.key,
                       comma_list(parameter_list(), &ParameterInfo::key)};
  }
  check_number(setting.value, {info->least, info->most});
}

void check_zone_attribute(const Setting& setting) {
  if (std::ranges::find(kZoneAttributes, setting.key) == std::end(kZoneAttributes)) {
    throw SettingError{true, "is no attribute of <zone> that may vary", setting.key,
                       comma_list(kZoneAttributes)};
  }
  if (setting.key == "openSpace") {
    check_number(setting.value, {kOpenSpaceLeast, kOpenSpaceMost});
  } else if (setting.key == "weather" && find_weather(setting.value) == nullptr) {
    throw SettingError{false, "is no weather", setting.value,
                       comma_list(weather_list(), &Weather::id)};
  } else if (split_words(setting.value).empty()) {
    throw SettingError{false, "is empty", "", "names, separated by spaces"};
  }
}

void check_panel_attribute(const Setting& setting) {
  const auto fields = panel_fields();
  if (std::ranges::find(fields, setting.key, &PanelField::attribute) == fields.end()) {
    throw SettingError{true, "is no attribute of <pedestrians>", setting.key,
                       comma_list(fields, &PanelField::attribute)};
  }
}

void check_option(Setting& setting) {
  try {
    setting.key = check_sumo_option(setting.key, setting.value);
  } catch (const SumoOptionError& error) {
    throw SettingError{error.value == setting.key, error.problem, error.value, error.allowed};
  }
}

void check_client_option(const Setting& setting) {
  if (setting.key.starts_with("-") && split_words(setting.key).size() == 1) return;
  throw SettingError{true, "is no option", setting.key,
                     "one of the client, such as --sensor-range"};
}

/// A checked setting of a zone.
void apply(const Setting& setting, ZoneSpec& zone) {
  double number = 0.0;
  parse_number(setting.value, number);
  if (setting.kind == SettingKind::kParameter) {
    zone.parameters.*find_parameter(setting.key)->member = number;
  } else if (setting.key == "openSpace") {
    zone.open_space = number;
  } else if (setting.key == "weather") {
    zone.weather = find_weather(setting.value);
  } else {
    auto& list = setting.key == "edges"       ? zone.edges
                 : setting.key == "edgeTypes" ? zone.edge_types
                 : setting.key == "lanes"     ? zone.lanes
                                              : zone.polygons;
    list = split_words(setting.value);
  }
}

}  // namespace

std::string attribute_of(SettingKind kind) {
  switch (kind) {
    case SettingKind::kSumo:
      return "sumo";
    case SettingKind::kPanel:
      return "panel";
    case SettingKind::kParameter:
      return "parameter";
    case SettingKind::kZone:
      return "zone";
    case SettingKind::kClient:
      return "client";
  }
  return "";
}

void check_setting(Setting& setting) {
  switch (setting.kind) {
    case SettingKind::kSumo:
      return check_option(setting);
    case SettingKind::kPanel:
      return check_panel_attribute(setting);
    case SettingKind::kParameter:
      return check_parameter(setting);
    case SettingKind::kZone:
      return check_zone_attribute(setting);
    case SettingKind::kClient:
      return check_client_option(setting);
  }
}

ZoneFile zone_file_of(const Study& study, const StudyScenario& scenario,
                      const std::vector<Setting>& settings) {
  ZoneFile file;
  if (!scenario.zone_file.empty()) file = read_zone_file(study.resolve(scenario.zone_file));
  PanelText panel{study.file, 0, {}};
  for (const Setting& setting : settings) {
    if (setting.kind == SettingKind::kSumo || setting.kind == SettingKind::kClient) continue;
    if (setting.kind == SettingKind::kPanel) {
      if (panel.line == 0) panel.line = setting.line;
      panel.values.emplace_back(setting.key, setting.value);
      continue;
    }
    if (file.zones.empty()) file.zones.emplace_back();
    for (ZoneSpec& zone : file.zones) apply(setting, zone);
  }
  if (!panel.values.empty()) {
    add_panel(file.panels, read_panel(panel, file.profiles, file.paths, file.panels.size()));
  }
  return file;
}

}  // namespace pedzone::study
