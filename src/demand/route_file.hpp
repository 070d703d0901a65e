// Planned people as a SUMO route file, for pedzone, for plain SUMO (striping) and for any other
// tool.
#pragma once

#include <string>
#include <vector>

#include "demand/people.hpp"

namespace pedzone {

/// The file's text: for each person a <vType> (so that it has its own speed and body) and a
/// <person> with its walk. The same people give the same bytes.
/// `comment`: what made it. `mean_share`: what striping's walkers reach of their maxSpeed in the
/// mean; maxSpeed is so much higher that a free person walks at its preferred speed in the mean,
/// whether striping or pedzone walks it.
std::string route_file(const std::vector<PlannedPerson>& people, const Network& network,
                       const std::string& comment, double mean_share);

}  // namespace pedzone
