// What plain SUMO says of itself.
#pragma once

#include <string>
#include <vector>

namespace pedzone::study {

/// What `sumo` prints when it is started with these arguments. Throws InputError where SUMO is not
/// installed, SumoError where it fails or dies.
std::string sumo_answer(const std::vector<std::string>& arguments);

}  // namespace pedzone::study
