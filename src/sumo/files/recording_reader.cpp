#include "sumo/files/recording_reader.hpp"

#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <unordered_map>
#include <unordered_set>

#include "results/trajectories.hpp"
#include "sumo/files/fcd_reader.hpp"

namespace pedzone {
namespace {

enum class Kind { kFcd, kTrajectories };

/// By the first character that is no space.
Kind kind_of(const std::string& file) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> input(gzopen(file.c_str(), "rb"), gzclose);
  if (!input || std::filesystem::is_directory(file)) {
    throw InputError("cannot be opened", {.file = file});
  }
  for (int c = 0; (c = gzgetc(input.get())) >= 0;) {
    if (c == '<') return Kind::kFcd;
    if (!std::isspace(c) && c != 0xEF && c != 0xBB && c != 0xBF) return Kind::kTrajectories;
  }
  int code = Z_OK;
  const char* reason = gzerror(input.get(), &code);
  if (code != Z_OK && code != Z_STREAM_END) {
    throw InputError(std::string("cannot be read (") + reason + ")", {.file = file});
  }
  throw InputError("is empty",
                   {.file = file, .allowed = "SUMO's fcd-output or pedzone's trajectories"});
}

/// Ends the reading of a file whose rest is not shown: it may be long.
struct AfterEnd {};

/// Tracks by id, and the times of the steps they are in.
class Collector {
 public:
  Collector(const RecordingSource& source, const RecordingCast& cast)
      : source_(source), cast_(cast), wanted_(source.persons.begin(), source.persons.end()) {}

  void read_fcd(const std::string& file, const ReadProgress& progress);
  void read_trajectories(const ReadProgress& progress);
  Recording take() {
    recording_.begin = first_;
    recording_.end = last_ + (std::isfinite(step_) ? step_ : 0.0);
    return std::move(recording_);
  }

 private:
  /// A step of the file that is shown.
  void note(double time) {
    if (time > last_) step_ = std::min(step_, time - last_);
    first_ = std::min(first_, time);
    last_ = std::max(last_, time);
  }

  std::uint32_t step_at(double time) {
    if (recording_.times.empty() || recording_.times.back() < time) {
      recording_.times.push_back(time);
    }
    return static_cast<std::uint32_t>(recording_.times.size() - 1);
  }
  bool shown(double time) const { return time >= source_.begin && time <= source_.end; }
  bool wanted(std::string_view id) const {
    return wanted_.empty() || wanted_.contains(std::string(id));
  }
  RecordedPerson& person(std::string_view id);
  RecordedVehicle& vehicle(const VehicleSample& sample, const FcdReader& reader);

  const RecordingSource& source_;
  const RecordingCast& cast_;
  std::unordered_set<std::string> wanted_;
  std::unordered_map<std::string, std::size_t> persons_, vehicles_;
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  double first_ = kNever, last_ = -kNever, step_ = kNever;  ///< [s]
  Recording recording_;
};

RecordedPerson& Collector::person(std::string_view id) {
  const auto [known, added] = persons_.try_emplace(std::string(id), recording_.persons.size());
  if (added) {
    const BodySize size = cast_.sizes.of_person(id);
    const PersonTraits traits = cast_.traits.of_person(id);
    recording_.persons.push_back({std::string(id),
                                  traits.profile,
                                  traits.group,
                                  size.length,
                                  size.width,
                                  disc_radius(size),
                                  {}});
  }
  return recording_.persons[known->second];
}

RecordedVehicle& Collector::vehicle(const VehicleSample& sample, const FcdReader& reader) {
  // Each part of one that bends is drawn by itself.
  std::string id(sample.id);
  if (sample.part > 0) id += ", part " + std::to_string(sample.part + 1);
  const auto [known, added] = vehicles_.try_emplace(id, recording_.vehicles.size());
  if (added) {
    recording_.vehicles.push_back(
        {id, reader.type_of(sample.id), sample.length, sample.width, {}, sample.part});
  }
  return recording_.vehicles[known->second];
}

void Collector::read_fcd(const std::string& file, const ReadProgress& progress) try {
  const std::unordered_set<std::string> none;
  FcdReader reader(cast_.sizes, none);
  reader.read(
      file,
      [&](double time, std::span<const PersonSample> persons,
          std::span<const VehicleSample> vehicles) {
        if (time > source_.end) throw AfterEnd();
        if (!shown(time)) return;
        note(time);
        if (persons.empty() && vehicles.empty()) return;
        const std::uint32_t step = step_at(time);
        for (const PersonSample& sample : persons) {
          if (!sample.rides_in.empty() || !wanted(sample.id)) continue;
          person(sample.id).moments.push_back({step, static_cast<float>(sample.heading),
                                               static_cast<float>(sample.velocity.norm()),
                                               std::nullopt, Activity::kNone, sample.position});
        }
        for (const VehicleSample& sample : vehicles) {
          vehicle(sample, reader)
              .moments.push_back({step, static_cast<float>(sample.heading),
                                  static_cast<float>(sample.velocity.norm()), sample.centre});
        }
      },
      progress);
} catch (const AfterEnd&) {
}

void Collector::read_trajectories(const ReadProgress& progress) {
  enum { kTime, kId };  // columns
  double last = -std::numeric_limits<double>::infinity();
  trajectory_table().visit(
      source_.file,
      [&](const TrajectoryRow& row, const CsvRow& fields) {
        if (row.time < last) throw fields.error("is earlier than the row before", kTime);
        last = row.time;
        if (!shown(row.time)) return;
        note(row.time);
        if (!wanted(row.id)) return;
        auto& moments = person(row.id).moments;
        const std::uint32_t step = step_at(row.time);
        if (!moments.empty() && moments.back().step == step) {
          throw fields.error("is there twice in this time step", kId);
        }
        moments.push_back({step, static_cast<float>(row.heading),
                           static_cast<float>(Vec2(row.vx, row.vy).norm()), row.motion,
                           row.activity, Vec2(row.x, row.y)});
      },
      progress);
}

void require_persons(const Recording& recording, const RecordingSource& source) {
  for (const std::string& id : source.persons) {
    if (std::ranges::find(recording.persons, id, &RecordedPerson::id) == recording.persons.end()) {
      throw InputError("is nobody in the recording",
                       {source.file, 0, "option --persons", id,
                        "ids of persons who are on foot there between --begin and --end"});
    }
  }
  if (recording.persons.empty() && source.needs_person) {
    throw InputError("has no person in the time shown",
                     {.file = source.file, .allowed = "a recording of persons on foot"});
  }
}

/// Adds the moments in which SUMO walked somebody to those in which pedzone did.
void add_walked_by_sumo(std::vector<PersonMoment>& moments, std::vector<PersonMoment>&& others) {
  std::erase_if(others, [&](const PersonMoment& one) {
    return std::ranges::binary_search(moments, one.step, {}, &PersonMoment::step);
  });
  for (PersonMoment& one : others) one.by_sumo = true;
  const auto middle = static_cast<std::ptrdiff_t>(moments.size());
  moments.insert(moments.end(), others.begin(), others.end());
  std::ranges::inplace_merge(moments, moments.begin() + middle, {}, &PersonMoment::step);
}

void take_persons(Recording& recording, std::vector<RecordedPerson>&& others) {
  std::unordered_map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < recording.persons.size(); ++i) places[recording.persons[i].id] = i;
  for (RecordedPerson& other : others) {
    const auto known = places.find(other.id);
    if (known == places.end()) {
      for (PersonMoment& moment : other.moments) moment.by_sumo = true;
      recording.persons.push_back(std::move(other));
    } else {
      add_walked_by_sumo(recording.persons[known->second].moments, std::move(other.moments));
    }
  }
}

/// Puts the vehicles of SUMO's recording of the same run into pedzone's, and those whom SUMO walks.
void take_others(Recording& recording, Recording&& other) {
  std::vector<double> times;
  std::ranges::set_union(recording.times, other.times, std::back_inserter(times));
  const auto renumber = [&times](const std::vector<double>& old, auto& tracks) {
    for (auto& track : tracks) {
      for (auto& moment : track.moments) {
        const auto place = std::ranges::lower_bound(times, old[moment.step]);
        moment.step = static_cast<std::uint32_t>(place - times.begin());
      }
    }
  };
  renumber(recording.times, recording.persons);
  renumber(other.times, other.vehicles);
  renumber(other.times, other.persons);
  take_persons(recording, std::move(other.persons));
  recording.vehicles = std::move(other.vehicles);
  recording.times = std::move(times);
  recording.begin = std::min(recording.begin, other.begin);
  recording.end = std::max(recording.end, other.end);
}

/// A table has no steps in which nobody was there: of what the user asks for, they count.
void take_as_asked(Recording& recording, const RecordingSource& source) {
  if (std::isfinite(source.begin)) recording.begin = source.begin;
  if (std::isfinite(source.end)) recording.end = source.end;
}

}  // namespace

bool is_trajectory_table(const std::string& file) { return kind_of(file) == Kind::kTrajectories; }

Recording read_recording(const RecordingSource& source, const RecordingCast& cast,
                         const ReadProgress& progress) {
  const Kind kind = kind_of(source.file);
  if (kind == Kind::kFcd && !source.fcd.empty()) {
    throw InputError("has vehicles of its own",
                     {source.file, 0, "option --fcd", source.fcd,
                      "--fcd beside pedzone's trajectories, which have none"});
  }
  Collector collector(source, cast);
  if (kind == Kind::kFcd) {
    collector.read_fcd(source.file, progress);
  } else {
    collector.read_trajectories(progress);
  }
  Recording recording = collector.take();
  if (!source.fcd.empty()) {
    Collector others(source, cast);
    others.read_fcd(source.fcd, progress);
    take_others(recording, others.take());
  } else if (kind == Kind::kTrajectories) {
    take_as_asked(recording, source);
  }
  require_persons(recording, source);
  return recording;
}

}  // namespace pedzone
