// What a geographical information system is given of a place and of a run: layers, one file each.
#pragma once

#include <string>
#include <vector>

#include "conflict/conflict.hpp"
#include "results/geojson_file.hpp"
#include "results/place.hpp"
#include "results/recording.hpp"

namespace pedzone {

/// A feature a zone: its ground.
void write_zones(const Place& place, GeoJsonFile& file);
/// A feature a border of the ground: a closed line.
void write_walls(const Place& place, GeoJsonFile& file);
/// A feature a waypoint of a <path> of the zone file.
void write_waypoints(const Place& place, GeoJsonFile& file);
/// A feature a person and time in which it was there without a gap of more than 5 s: its way.
void write_paths(const Recording& recording, GeoJsonFile& file);
/// A feature a cell in which anybody was: its mean density over the recording.
void write_density(const Recording& recording, GeoJsonFile& file);
/// A feature a conflict, where its gravest measure has its extreme.
void write_conflicts(const std::vector<Conflict>& conflicts, GeoJsonFile& file);

}  // namespace pedzone
