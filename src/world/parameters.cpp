#include "world/parameters.hpp"

namespace pedzone {
namespace {

using P = Parameters;

// What `pedzone calibrate` found, with its scores.
#define calibrated(key, value) constexpr double calibrated_##key = value;
#include "world/calibrated.inc"
#undef calibrated

constexpr ParameterInfo kParameters[] = {
    {"sight", &P::sight, 10.0, 1.0, 50.0, "m", "how far a person sees: d_max of Eq. 1 and 2",
     "Moussaid 2011"},
    {"fieldOfView", &P::field_of_view, 90.0, 10.0, 180.0, "deg",
     "half angle within which a person sees", "Moussaid 2011 (75 to 90)"},
    {"candidateField", &P::candidate_field, 75.0, 10.0, 180.0, "deg",
     "half angle of the 61 candidate directions about the heading", "Moussaid 2011"},
    {"relaxationTime", &P::relaxation_time, 0.5, 0.05, 5.0, "s",
     "time in which the velocity approaches the chosen one", "Moussaid 2011"},
    {"collisionTime", &P::collision_time, 0.5, 0.05, 5.0, "s",
     "t_coll of Eq. 3: least time to a contact that a person keeps",
     "assumed: the relaxation time of Moussaid 2011"},
    {"hearing", &P::hearing, 8.0, 0.0, 50.0, "m",
     "how far a moving vehicle is heard outside the field of view", "assumed"},
    {"equation", &P::equation, 2.0, 1.0, 2.0, "",
     "1: original direction rule (Eq. 1), 2: extended (Eq. 2)", "Jan, Kleen and Berns"},
    {"waypointRadius", &P::waypoint_radius, 1.0, 0.1, 20.0, "m",
     "radius (epsilon) in which a waypoint counts as reached", "assumed"},
    {"patience", &P::patience, 10.0, 1.0, 600.0, "s",
     "blocked for so long, a person goes on to the next waypoint", "assumed"},
    {"headingNoise", &P::heading_noise, 2.0, 0.0, 30.0, "deg",
     "standard deviation of the heading's variation; 0 switches it off", "assumed"},
    {"headingNoiseTime", &P::heading_noise_time, 1.0, 0.05, 60.0, "s",
     "correlation time of that variation", "assumed"},
    {"waitDistance", &P::wait_distance, 3.0, 0.0, 20.0, "m",
     "`plain` only: a person waits when a vehicle will cross its way nearer than this ...",
     "assumed"},
    {"waitTime", &P::wait_time, 3.0, 0.0, 20.0, "s", "... and sooner than this", "assumed"},
    {"nearDistance", &P::near_distance, 2.0, 0.0, 20.0, "m",
     "when the best direction is blocked nearer than this, the whole circle is searched",
     "assumed"},
    {"turnedWidth", &P::turned_width, 0.5, 0.45, 1.0, "",
     "width of a body with its shoulders turned, over its full one; 1: nobody turns",
     "depth over width: 0.45 of SUMO's person, and clothes"},
    {"turnTime", &P::turn_time, 1.0, 0.0, 5.0, "s",
     "who finds no direction that people leave free for so long ahead turns the shoulders",
     "assumed"},
    {"jamTime", &P::jam_time, 60.0, 1.0, 3600.0, "s",
     "who has not come 0.5 m nearer for so long, with only people in the way, squeezes through",
     "assumed; striping's jamtime is 300 s"},
    {"groupMaximumDistance", &P::group_maximum_distance, 4.0, 0.5, 50.0, "m",
     "who is farther ahead of the last of its group waits ...", "assumed"},
    {"groupPreferredDistance", &P::group_preferred_distance, 1.5, 0.0, 50.0, "m",
     "... until it is no farther than this", "assumed"},
    {"vehicleSight", &P::vehicle_sight, 25.0, 1.0, 100.0, "m",
     "how far a moving vehicle is seen by those who give way by discomfort (at least sight)",
     "assumed: 4 s before a vehicle at 5 m/s"},
    {"discomfort", &P::discomfort, calibrated_discomfort, 0.0, 100.0, "",
     "k: weight of the discomfort near moving vehicles; 0: vehicles as in the paper",
     "calibrated, then by hand (src/validation/README.md)"},
    {"discomfortMargin", &P::discomfort_margin, calibrated_discomfortMargin, 0.0, 10.0, "m",
     "m0: clearance to a vehicle below which discomfort begins ...",
     "calibrated (pedzone calibrate)"},
    {"discomfortMarginTime", &P::discomfort_margin_time, calibrated_discomfortMarginTime, 0.0, 10.0,
     "s", "m_v: ... and by how much more for each m/s of the vehicle",
     "calibrated (pedzone calibrate)"},
    {"discomfortHorizon", &P::discomfort_horizon, calibrated_discomfortHorizon, 0.0, 20.0, "s",
     "T: how far ahead in time discomfort is foreseen",
     "calibrated, then by hand (src/validation/README.md)"},
    {"slowingCost", &P::slowing_cost, calibrated_slowingCost, 0.0, 100.0, "",
     "w: what slowing down costs against going round", "calibrated (pedzone calibrate)"},
    {"hurryCost", &P::hurry_cost, 1.0, 0.0, 100.0, "",
     "what walking faster than preferred costs, as w for slowing down",
     "assumed: a fifth more speed costs as much as 23 degrees aside"},
    {"marginSpread", &P::margin_spread, calibrated_marginSpread, 0.0, 2.0, "",
     "sigma: by how much people differ in that margin (of its logarithm)",
     "calibrated (pedzone calibrate)"},
    {"roomBehind", &P::room_behind, calibrated_roomBehind, 0.0, 2.0, "",
     "share by which that margin is larger for a vehicle that drives the person's way",
     "calibrated, then by hand (src/validation/README.md)"},
    {"lettingPass", &P::letting_pass, calibrated_lettingPass, 0.0, 1.0, "",
     "share of the speed that a person gives up for such a vehicle beside it, to let it pass",
     "calibrated, then by hand (src/validation/README.md)"},
    {"meeting", &P::meeting, 0.09, 0.0, 1.0, "",
     "share of the speed that a person gives up before a vehicle that comes towards it",
     "fitted to the least speeds in CITR, front; they walk at 0.94 of theirs on average"},
    {"crossingStartUp", &P::crossing_start_up, 1.0, 0.0, 10.0, "s",
     "crossing=\"anywhere\": from the decision to cross a street to the first step",
     "Highway Capacity Manual 2010: 3 s with the margin"},
    {"crossingMargin", &P::crossing_margin, 2.0, 0.0, 20.0, "s",
     "... what a person leaves of a gap when it has not waited; times its profile's caution",
     "Highway Capacity Manual 2010: 3 s with the start-up"},
    {"crossingMarginLeast", &P::crossing_margin_least, 0.5, 0.0, 20.0, "s",
     "... what it leaves when it has waited for crossingMarginTime", "assumed"},
    {"crossingMarginTime", &P::crossing_margin_time, 60.0, 1.0, 3600.0, "s",
     "... so long a margin falls while a person waits", "assumed"},
    {"crossingAversion", &P::crossing_aversion, 5.0, 0.0, 600.0, "s",
     "a crossing between junctions must save at least this much time", "assumed"},
    {"crossingInsists", &P::crossing_insists, 60.0, 0.0, 3600.0, "s",
     "... who has waited for so long steps out before vehicles that can stop in comfort",
     "assumed"},
    {"yieldGap", &P::yield_gap, 1.0, 0.0, 10.0, "m",
     "gap at which a yielding vehicle stops before a person in its way", "assumed"},
    {"yieldMargin", &P::yield_margin, 0.2, 0.0, 3.0, "m",
     "side margin: a person nearer than this to the swept area is in the vehicle's way", "assumed"},
    {"yieldHorizon", &P::yield_horizon, 15.0, 1.0, 100.0, "m",
     "how far beyond its braking distance a vehicle looks for people", "assumed"},
    {"creepAfter", &P::creep_after, 20.0, 0.0, 3600.0, "s",
     "a vehicle that people have held up for so long begins to creep", "assumed"},
    {"creepSpeed", &P::creep_speed, 1.0, 0.0, 3.0, "m/s", "at most this fast", "assumed"},
    {"creepGap", &P::creep_gap, 0.3, 0.05, 5.0, "m",
     "gap that a creeping vehicle keeps to the person before it", "assumed"},
};

}  // namespace

Parameters::Parameters() {
  for (const ParameterInfo& info : kParameters) this->*info.member = info.value;
}

std::span<const ParameterInfo> parameter_list() { return kParameters; }

const ParameterInfo* find_parameter(std::string_view key) {
  for (const ParameterInfo& info : kParameters) {
    if (info.key == key) return &info;
  }
  return nullptr;
}

}  // namespace pedzone
