// Where SUMO's data lies.
#pragma once

namespace pedzone {

/// Sets SUMO_HOME for this process and those it starts, where it is not set and SUMO lies in a
/// usual place: without it, SUMO looks on the net for the schemas that most files name, and refuses
/// them. Not to be called beside other threads.
void find_sumo_data();

}  // namespace pedzone
