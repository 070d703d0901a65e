// Recordings of people around vehicles, and what is read from them.
#pragma once

#include <string>
#include <vector>

#include "world/snapshot.hpp"

namespace pedzone {

/// Recordings and scores are at 10 Hz; times are counted in frames.
inline constexpr double kFrame = 0.1;  // [s]
/// Frames in which a replayed person follows the recording (validation.md, protocol 2).
inline constexpr int kFollows = 10;
/// Frames over which somebody present sees a velocity.
inline constexpr int kPast = 3;

struct PersonTrack {
  std::string id;
  int first = 0;    ///< frame of the first position
  Polyline places;  ///< [m] one a frame, without gaps
  int last() const { return first + static_cast<int>(places.size()) - 1; }
};

struct VehicleTrack {
  std::string id;
  int first = 0;
  std::vector<VehicleState> states;  ///< one a frame, of the rectangle's centre; the velocity is
                                     ///< that of the last 0.3 s, as somebody present sees it
  int last() const { return first + static_cast<int>(states.size()) - 1; }
};

struct Clip {
  std::string name;       ///< of its file, without the ending
  std::string site;       ///< of its folder
  std::string manoeuvre;  ///< "lateral one-way", "lateral two-way", "front", "back", ...
  std::vector<PersonTrack> persons;
  std::vector<VehicleTrack> vehicles;
};

/// What clips are grouped by: "site: manoeuvre".
inline std::string group_of(const Clip& clip) { return clip.site + ": " + clip.manoeuvre; }

/// Reads all clips (*.csv) of `folder`, or of its sub-folders, one for each site; ordered by site
/// and name. Columns: t [s], kind (ped or veh), id, x, y [m], and for vehicles heading [rad, ccw
/// from +x], front, rear, half_width [m from the reference point]; others are not read.
/// Throws InputError naming file and line for missing columns, what is no number, gaps in time, and
/// vehicles without size.
std::vector<Clip> read_clips(const std::string& folder);

/// The vehicle at `frame`, or nullptr when it is not there.
inline const VehicleState* at_frame(const VehicleTrack& vehicle, int frame) {
  if (frame < vehicle.first || frame > vehicle.last()) return nullptr;
  return &vehicle.states[static_cast<std::size_t>(frame - vehicle.first)];
}

}  // namespace pedzone
