// What a scenario says of a person: parameters pedzone.* of the person, of its vType, or of the
// member that a vTypeDistribution gave it (the person's own first).
#pragma once

#include <string>

#include "sumo/calls/persons.hpp"
#include "sumo/files/hint_values.hpp"

namespace pedzone {

/// Reads them from SUMO for a person that is there now. Throws InputError naming the person, the
/// key, the value and what is allowed, for what a program has set since the files were read.
PersonHints read_hints(const SumoPersons& sumo, const std::string& person,
                       const HintContext& context);

}  // namespace pedzone
