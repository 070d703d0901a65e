// What a level of a factor sets, checked one by one.
#pragma once

#include <string>

#include "study/plan/study_file.hpp"
#include "zone/zone_file.hpp"

namespace pedzone::study {

/// Why a setting is none.
struct SettingError {
  bool of_key;  ///< else of the value
  std::string problem, value, allowed;
};

/// The attribute of the study file that names the kind: sumo, panel, parameter or zone.
std::string attribute_of(SettingKind kind);

/// Throws SettingError for an unknown key or a value that it cannot have; SUMO's options get their
/// first name. What panel settings mean together is checked by zone_file_of().
void check_setting(Setting& setting);

/// What a scenario's zone file says with the settings. Throws InputError for a zone file that is at
/// fault, and where the panel settings together make no people.
ZoneFile zone_file_of(const Study& study, const StudyScenario& scenario,
                      const std::vector<Setting>& settings);

}  // namespace pedzone::study
