#include "study/measure/measure_list.hpp"

#include <algorithm>

namespace pedzone::study {
namespace {

constexpr Measure kMeasures[] = {
    {"person.travelTime", "Travel time", "s",
     "Mean time from the intended departure to the end of the last walk or ride, or of the run, of "
     "all who were due before it.",
     "People", true},
    {"person.arrived", "Share arrived", "", "Of those who were due, by the end of the run.",
     "People", true},
    {"person.delay", "Delay in the zone", "s",
     "Mean time walking in the zone less that of the shortest way, with room for the body, at the "
     "person's free speed: SUMO's maximum less what striping dawdles. Below 0: it does not dawdle, "
     "or crosses streets between the junctions, which the shortest way does not.",
     "People", true},
    {"person.waiting", "Waiting in the zone", "s",
     "Mean time standing (slower than 0.1 m/s) on walks in the zone.", "People", true},
    {"person.speed", "Speed in the zone", "m/s",
     "Mean over time of the speeds that SUMO reports for those who walk in the zone.", "People",
     true},
    {"person.detour", "Detour factor", "",
     "Distance walked in the zone over the shortest by the junctions, all people together. Below "
     "1: through obstacles, as SUMO's own models do, or across streets between the junctions.",
     "People", true},
    {"person.travelTime85", "Travel time, 85th percentile", "s",
     "So long or less for 85 of 100 persons.", "People", false},
    {"person.travelTime95", "Travel time, 95th percentile", "s", "For 95 of 100.", "People", false},
    {"person.delay85", "Delay in the zone, 85th percentile", "s",
     "So much or less for 85 of 100 persons who walk there.", "People", false},
    {"person.delay95", "Delay in the zone, 95th percentile", "s", "For 95 of 100.", "People",
     false},
    {"person.walked", "Walked in the zone", "m",
     "Mean distance walked in the zone, from place to place; a jump counts, too.", "People", false},
    {"person.jumped", "Jumped in the zone", "m",
     "Mean distance by which they were put on there without walking it: by SUMO's striping over "
     "junctions that have no walking areas, by its nonInteracting over all.",
     "People", false},
    {"person.jams", "Jams", "",
     "Times that somebody stuck among people was let through: by striping after jamtime, by "
     "pedzone's models after jamTime.",
     "People", false},
    {"person.nearlyAll", "Nearly all arrived", "s",
     "Time by which 99 % of those who were due have arrived. Where the run ends before: as if they "
     "went on to arrive as in its last quarter.",
     "People", false},
    {"person.count", "Persons", "", "Due to depart before the end of the run.", "People", false},
    {"person.visitors", "In the zone", "",
     "Persons who have walked in the zone: on its edges, or in a junction between two of them. "
     "All that is told of the zone is told of people there.",
     "People", false},
    {"crossing.count", "Streets crossed", "",
     "Times that somebody got from one side of a street of the zone to the other "
     "(crossing=\"anywhere\").",
     "Crossing", false, true},
    {"crossing.between", "Between the junctions", "",
     "Share of those between the junctions and not at one of them.", "Crossing", false, true},
    {"crossing.wait", "Wait at the kerb", "s",
     "Mean time standing there (slower than 0.3 m/s) before crossing between the junctions.",
     "Crossing", false, true},
    {"crossing.gap", "Gap that half of them take", "s",
     "Of the gaps between vehicles that were taken and let pass, by a logistic regression.",
     "Crossing", false, true},
    {"crossing.near", "Conflicts on the near half", "",
     "Of the conflicts, those of people who cross between the junctions, on the half of the "
     "carriageway beside the kerb that they come from. With two directions that half is one of "
     "them.",
     "Crossing", false, true},
    {"crossing.far", "Conflicts on the far half", "", "The same on the other half.", "Crossing",
     false, true},
    {"space.density", "Density met", "1/m²",
     "Mean density that those who walk in the zone are in: people on foot within 2 m of the "
     "person, itself too, over that circle's area.",
     "Space", true},
    {"space.peak", "Peak density met", "1/m²", "The greatest mean over 10 s of it.", "Space",
     false},
    {"space.levelA", "Level of service A", "",
     "Share of people's time in the zone at more than 3.25 m² each, by the density met.", "Space",
     false},
    {"space.levelB", "Level of service B", "", "2.32 to 3.25 m² each (Fruin 1971, walkways).",
     "Space", false},
    {"space.levelC", "Level of service C", "", "1.39 to 2.32 m² each.", "Space", false},
    {"space.levelD", "Level of service D", "", "0.93 to 1.39 m² each.", "Space", false},
    {"space.levelE", "Level of service E", "", "0.46 to 0.93 m² each.", "Space", false},
    {"space.levelF", "Level of service F", "", "Less than 0.46 m² each.", "Space", false},
    {"space.jammed", "Time in jams", "",
     "Share of people's time in the zone in a jam: standing for 5 s or more with two others who do "
     "within 2 m.",
     "Space", false},
    {"vehicle.travelTime", "Travel time", "s",
     "Mean time from the intended departure to the arrival, or to the end of the run, of all that "
     "were due before it.",
     "Vehicles", true},
    {"vehicle.delay", "Delay", "s",
     "Mean of what SUMO reports as time lost on the way and as delay of the departure.", "Vehicles",
     true},
    {"vehicle.stops", "Stops", "",
     "Times that a vehicle came to a stand after it went at 1 m/s or more, per vehicle due; "
     "planned stops, too.",
     "Vehicles", true},
    {"vehicle.arrived", "Share arrived", "", "Of those due, by the end of the run.", "Vehicles",
     false},
    {"vehicle.count", "Vehicles", "", "Due to depart before the end of the run.", "Vehicles",
     false},
    {"vehicle.teleports", "Teleports", "",
     "Times that SUMO put a vehicle farther on, since it had stood for too long or had collided. "
     "That shortens travel times.",
     "Vehicles", false},
    {"conflict.count", "Conflicts", "",
     "Encounters in the zone with a vehicle that moves at more than 0.5 m/s: with TTC < 3 s, "
     "PET < 2 s or DRAC > 3 m/s², and contacts. Each is judged at its contact, else at its least "
     "TTC, else at its PET.",
     "Conflicts", true},
    {"conflict.serious", "Serious conflicts", "", "Those with TTC < 1.5 s, PET < 1 s, or contact.",
     "Conflicts", true},
    {"conflict.contacts", "Contacts", "",
     "Pairs whose bodies touched in the zone while the vehicle moved.", "Conflicts", true},
    {"conflict.standing", "Conflicts with standing vehicles", "",
     "The same with a vehicle that stood or crept at 0.5 m/s or less: people walk close past it.",
     "Conflicts", false},
    {"conflict.seriousStanding", "Serious ones of these", "",
     "Those with TTC < 1.5 s, PET < 1 s, or contact.", "Conflicts", false},
    {"conflict.contactsStanding", "Contacts with standing vehicles", "",
     "Bodies touched; the vehicle ran into nobody.", "Conflicts", false},
    {"conflict.insertions", "Insertions", "",
     "Pairs of which SUMO put one onto the other, departing or teleported. Counted nowhere else.",
     "Conflicts", false},
    {"conflict.headOn", "Head-on", "", "Of the conflicts: person and vehicle towards each other.",
     "Conflicts", false},
    {"conflict.fromBehind", "From behind", "", "The vehicle behind the person.", "Conflicts",
     false},
    {"conflict.following", "Following", "", "The person behind the vehicle.", "Conflicts", false},
    {"conflict.crossing", "Crossing", "", "From the vehicle's left or right.", "Conflicts", false},
    {"conflict.ttc", "TTC", "s", "Median of the conflicts' least times to contact.", "Conflicts",
     false},
    {"conflict.pet", "PET", "s", "Median of their post-encroachment times.", "Conflicts", false},
    {"conflict.drac", "DRAC", "m/s²", "Median of their greatest decelerations to avoid contact.",
     "Conflicts", false},
    {"conflict.clearance", "Smallest clearance", "m", "Of all conflicts of the run; contact: 0.",
     "Conflicts", false},
    {"conflict.pushed", "Persons pushed", "",
     "Persons whom a vehicle that drives pushed by 1 cm or more. SUMO's own models push nobody: "
     "vehicles drive through people.",
     "Conflicts", false},
    {"conflict.pushWay", "Longest push", "m", "The longest way that a vehicle pushed somebody.",
     "Conflicts", false},
    {"conflict.pushSpeed", "Fastest push", "m/s", "The fastest of these pushes; 3 at most.",
     "Conflicts", false},
    {"conflict.runInto", "Run into", "",
     "Times that a vehicle ran into somebody: it would have had to push faster, or there was no "
     "room.",
     "Conflicts", false},
};

}  // namespace

std::span<const Measure> measure_list() { return kMeasures; }

const Measure* find_measure(std::string_view key) {
  const auto* found = std::ranges::find(kMeasures, key, &Measure::key);
  return found == std::end(kMeasures) ? nullptr : found;
}

}  // namespace pedzone::study
