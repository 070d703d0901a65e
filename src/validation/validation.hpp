// Walking models against recordings: every figure, for every set and group of persons.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "validation/scores.hpp"

namespace pedzone {

/// Which persons count (validation.md, protocol 5).
enum class PersonSet {
  kRecorded,  ///< recorded clearance to a moving vehicle under 3 m
  kStraight   ///< that clearance of walking straight to the goal under 3 m: unlike the first, it
              ///< does not leave out those, and only those, whom giving way took farther away
};
const char* name_of(PersonSet set);  ///< "recorded", "straight"

/// From fewer clips the bootstrap by clip says nothing: of two it knows three mixtures (ours).
inline constexpr std::size_t kLeastClips = 5;

struct ValidationOptions {
  std::vector<ReplayModel> models;  ///< besides the reference rows
  int seeds = 5;                    ///< at least 5 jittered seeds (protocol 6)
  int resamples = 1000;             ///< of the bootstrap by clip
  bool references = true;           ///< straight, constant velocity and plain, too
};

/// One row of the table: a model ("recorded": the recording itself) in a group of a set.
struct ValidationRow {
  PersonSet set = PersonSet::kRecorded;
  std::string group;  ///< "all", a site, or a site and manoeuvre ("citr: back")
  std::string model;
  std::size_t persons = 0, clips = 0;
  Figures value, low, high;  ///< mean over seeds, and the 95 % bootstrap interval by clip: not a
                             ///< number from fewer than kLeastClips, and of counts
};

/// A person as a model walked it, for drawing.
struct DrawnCase {
  std::string model, clip, person, group;
  int first = 0;                                      ///< frame of the places' begin
  Polyline recorded, walked;                          ///< [m] one place a frame
  std::vector<std::pair<int, VehicleState>> vehicle;  ///< where the nearest one was, by frame
  Measures was, became;
};

struct ValidationResult {
  std::size_t clips = 0, persons = 0, scored = 0;
  int seeds = 0;
  std::vector<std::string> models;  ///< in the order of the tables, reference rows first
  std::vector<ValidationRow> rows;
  std::vector<Clip> data;
  std::vector<ScoredRuns> runs;  ///< for each of `models`
};

/// Called with how much is done, [0, 1], from any thread.
using Progressed = std::function<void(double)>;

/// Replays all clips with the reference models (straight to the goal, constant velocity, plain) and
/// with those of the options. Same input, same result, for any number of threads.
ValidationResult validate(std::vector<Clip> clips, const ValidationOptions& options,
                          const Progressed& progressed);

/// The persons of a run that are in the set and group.
std::vector<const ScoredPerson*> members(const ValidationResult& result, const ScoredRuns& runs,
                                         std::size_t seed, PersonSet set, const std::string& group);

/// Groups in the order of the tables: "all" where there are several sites, sites, manoeuvres.
std::vector<std::string> groups_of(const std::vector<Clip>& clips);

/// The `count` persons of the model (seed 1, recorded set) whose ways differ most from the
/// recording, by ADE; not more than one of each clip.
std::vector<DrawnCase> worst_cases(const ValidationResult& result, const ReplayModel& model,
                                   std::size_t count);

}  // namespace pedzone
