// Where a network lies on Earth, as its file says.
#pragma once

#include <string>

#include "results/geo_frame.hpp"

namespace pedzone {

/// Reads the <location> of a .net.xml or .net.xml.gz. Throws InputError where the file is missing
/// or malformed.
GeoReference read_geo_reference(const std::string& net_file);

}  // namespace pedzone
