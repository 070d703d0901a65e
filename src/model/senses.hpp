// How far and wide people perceive.
#pragma once

#include <string_view>

#include "model/walker.hpp"
#include "world/attention.hpp"
#include "world/parameters.hpp"

namespace pedzone {

/// How vehicles are minded: as in the paper (obstacles that move, and the waiting rule), or as more
/// than obstacles, by a discomfort that grows before contact (giving_way.hpp; none: as in the
/// paper) or by a model's own rule.
enum class VehicleForm { kPlain, kDiscomfort };

/// Of a walking model by its name.
inline VehicleForm vehicle_form(std::string_view model) {
  return model == "plain" || model == "heuristic-original" ? VehicleForm::kPlain
                                                           : VehicleForm::kDiscomfort;
}

bool minds_discomfort(const Parameters& parameters, VehicleForm form);

/// How far and wide people perceive by that form: those who mind vehicles as more than obstacles
/// see moving ones farther than people.
Senses senses_of(const Parameters& parameters, VehicleForm form);

/// The same for one who perceives differently.
Senses with(Senses senses, const Perception& perception);

}  // namespace pedzone
