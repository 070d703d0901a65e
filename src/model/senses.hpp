// How far and wide people perceive.
#pragma once

#include "model/walker.hpp"
#include "model/walking_model.hpp"
#include "world/attention.hpp"
#include "world/parameters.hpp"

namespace pedzone {

bool minds_discomfort(const Parameters& parameters, VehicleForm form);

/// How far and wide people perceive by that form: those who mind vehicles as more than obstacles
/// see moving ones farther than people.
Senses senses_of(const Parameters& parameters, VehicleForm form);

/// The same for one who perceives differently.
Senses with(Senses senses, const Perception& perception);

/// The person as it looks round: its place, body, velocity and where it faces.
Walker onlooker(const Persons& persons, std::size_t person, const LatticeOrigin& origin);

}  // namespace pedzone
