// What a level of a factor sets, checked one by one.
#pragma once

#include <string>

#include "study/study_file.hpp"

namespace pedzone {

/// Why a setting is none.
struct SettingError {
  bool of_key;  ///< else of the value
  std::string problem, value, allowed;
};

/// The attribute of the study file that names the kind: sumo, panel, parameter or zone.
std::string attribute_of(SettingKind kind);

/// Throws SettingError for an unknown key or a value that it cannot have; SUMO's options get their
/// first name. What panel settings mean together is checked by check_panels().
void check_setting(Setting& setting);

/// Throws InputError where the panel settings of a condition make no people.
void check_panel(const Study& study, const StudyScenario& scenario,
                 const std::vector<Setting>& settings);

}  // namespace pedzone
