#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "conflict/approach.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "view/animation_parts.hpp"
#include "view/packed_numbers.hpp"
#include "world/speeds.hpp"

namespace pedzone::animation {
namespace {

constexpr int kNoFrame = -1;
constexpr int kPerTurn = 720;  // headings are kept in half degrees

/// The steps that are kept.
struct Frames {
  std::vector<double> times;  ///< [s]
  std::vector<int> of_step;   ///< index into `times` for each step of the recording, or kNoFrame
  double step = 0.0;          ///< [s] the usual time from one to the next; 0: there is only one
};

/// [s] median time from one step to the next; 0: there is only one.
double usual_step(std::vector<double> times) {
  if (times.size() < 2) return 0.0;
  std::adjacent_difference(times.begin(), times.end(), times.begin());
  const auto middle = times.begin() + 1 + (times.size() - 1) / 2;
  std::nth_element(times.begin() + 1, middle, times.end());
  return *middle;
}

Frames frames_of(const Recording& recording, double rate) {
  constexpr double kRounding = 1e-6;  // [s] numerical: times are decimal
  const double recorded = usual_step(recording.times);
  Frames frames;
  // A whole number of steps, so that frames are as regular as steps.
  const double least =
      recorded > 0.0 ? recorded * std::ceil(1.0 / rate / recorded - kRounding) : 0.0;
  frames.step = least;
  for (const double time : recording.times) {
    const bool first = frames.times.empty();
    const double since = first ? 0.0 : time - frames.times.back();
    if (!first && since < least - kRounding) {
      frames.of_step.push_back(kNoFrame);
      continue;
    }
    // Nobody was there for a while: an empty frame, so that nobody glides from before to after.
    if (!first && since > 1.5 * least) frames.times.push_back(frames.times.back() + least);
    frames.of_step.push_back(static_cast<int>(frames.times.size()));
    frames.times.push_back(time);
  }
  return frames;
}

/// Where everybody is: one number for each of them and frame, kept as differences.
struct Columns {
  DifferenceRows x{DifferenceRows::Order::kSecond}, y{DifferenceRows::Order::kSecond},
      heading{DifferenceRows::Order::kFirst}, speed{DifferenceRows::Order::kFirst};
  int turned = 0;  ///< the last heading, going on beyond a full turn

  void begin_row() {
    for (DifferenceRows* column : {&x, &y, &heading, &speed}) column->begin_row();
    turned = 0;
  }
  void add(const Vec2& place, double angle, double metres_per_second) {
    x.add(centimetres(place.x()));
    y.add(centimetres(place.y()));
    const auto wanted = static_cast<int>(std::lround(wrap_angle(angle) / (2.0 * kPi) * kPerTurn));
    turned += static_cast<int>(std::remainder(wanted - turned, kPerTurn));
    heading.add(turned);
    speed.add(centimetres(metres_per_second));
  }
};

const Vec2& place_of(const PersonMoment& moment) { return moment.position; }
const Vec2& place_of(const VehicleMoment& moment) { return moment.centre; }

constexpr int kBySumo = 3;  // after the motions: SUMO walks the person, walked by SUMO

/// What SUMO's own output does not tell is told from the speed.
int motion_of(const PersonMoment& moment) {
  if (moment.by_sumo) return kBySumo;
  const Motion by_speed = moment.speed < kHaltingSpeed ? Motion::kStanding : Motion::kWalking;
  return static_cast<int>(moment.motion.value_or(by_speed));
}

/// [[samples since its first, motion, activity], ...]: whenever they change.
class Changes {
 public:
  void add(std::size_t sample, const PersonMoment& moment) {
    const int motion = motion_of(moment);
    const auto activity = static_cast<int>(moment.activity);
    if (!text_.empty() && motion == motion_ && activity == activity_) return;
    if (!text_.empty()) text_ += ',';
    fmt::format_to(std::back_inserter(text_), "[{},{},{}]", sample, motion, activity);
    motion_ = motion;
    activity_ = activity;
  }
  void add(std::size_t, const VehicleMoment&) {}
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  int motion_ = 0, activity_ = 0;
};

struct Track {
  std::string spans, changes;  ///< JSON, without the brackets
};

/// Adds one's moments to the columns; empty spans where no frame has it.
template <class Moment>
Track add_track(const std::vector<Moment>& moments, const Frames& frames, Columns& columns) {
  Track track;
  Changes changes;
  int first = kNoFrame, next = kNoFrame;
  std::size_t samples = 0;
  const auto end_span = [&] {
    if (first == kNoFrame) return;
    if (!track.spans.empty()) track.spans += ',';
    fmt::format_to(std::back_inserter(track.spans), "[{},{}]", first, next - first);
  };
  for (const Moment& moment : moments) {
    const int frame = frames.of_step[moment.step];
    if (frame == kNoFrame) continue;
    if (frame != next) {
      end_span();
      first = frame;
      columns.begin_row();
    }
    columns.add(place_of(moment), moment.heading, moment.speed);
    changes.add(samples++, moment);
    next = frame + 1;
  }
  end_span();
  track.changes = changes.text();
  return track;
}

std::string persons(const Recording& recording, const Frames& frames, Columns& columns) {
  std::string text;
  for (const RecordedPerson& person : recording.persons) {
    const Track track = add_track(person.moments, frames, columns);
    if (track.spans.empty()) continue;
    if (!text.empty()) text += ",\n";
    fmt::format_to(std::back_inserter(text),
                   R"({{"id":{},"profile":{},"group":{},"radius":{:.3f},"length":{:.3f},)"
                   R"("width":{:.3f},"spans":[{}],"changes":[{}]}})",
                   json_string(person.id), json_string(person.profile), json_string(person.group),
                   person.radius, person.length, person.width, track.spans, track.changes);
  }
  return text;
}

std::string vehicles(const Recording& recording, const Frames& frames, Columns& columns) {
  std::string text;
  for (const RecordedVehicle& vehicle : recording.vehicles) {
    const Track track = add_track(vehicle.moments, frames, columns);
    if (track.spans.empty()) continue;
    if (!text.empty()) text += ",\n";
    fmt::format_to(std::back_inserter(text),
                   R"({{"id":{},"type":{},"length":{:.3f},"width":{:.3f},"part":{},"spans":[{}]}})",
                   json_string(vehicle.id), json_string(vehicle.type), vehicle.length,
                   vehicle.width, vehicle.part, track.spans);
  }
  return text;
}

/// In ms from the first one.
std::string packed_times(const Frames& frames) {
  constexpr double kLongest = 2e6;  // [s] 32 bits hold it in ms
  const double begin = frames.times.front(), length = frames.times.back() - begin;
  if (length > kLongest) {
    throw InputError("is too long to be shown",
                     {.element = "a recording",
                      .value = fmt::format("{} s", length),
                      .allowed = fmt::format("{:g} s; see --begin and --end", kLongest)});
  }
  DifferenceRows rows(DifferenceRows::Order::kSecond);
  for (const double time : frames.times) {
    rows.add(static_cast<std::int32_t>(std::lround(1000.0 * (time - begin))));
  }
  return packed(rows.differences());
}

/// Names in the order of their enum.
std::string motion_names() {
  return fmt::format(R"(["{}","{}","{}","walked by SUMO"])", name_of(Motion::kWalking),
                     name_of(Motion::kWaiting), name_of(Motion::kStanding));
}

std::string activity_names() {
  const auto name = [](const ActivityInfo& info) { return json_string(info.id); };
  return '[' + separated_list(activity_list(), ",", name) + ']';
}

}  // namespace

std::string run(const AnimatedRun& run, double rate) {
  const Frames frames = frames_of(*run.recording, rate);
  Columns columns;
  const std::string who = persons(*run.recording, frames, columns);
  const std::string what = vehicles(*run.recording, frames, columns);
  return fmt::format(
      R"({{"name":{},"motions":{},"activities":{},"frames":{},"samples":{},"begin":{},)"
      R"("times":"{}",)"
      R"("x":"{}","y":"{}","heading":"{}","speed":"{}",)"
      "\n\"persons\":[{}],\n\"vehicles\":[{}]}}",
      json_string(run.name), motion_names(), activity_names(), frames.times.size(),
      columns.x.differences().size(), frames.times.front(), packed_times(frames),
      packed(columns.x.differences()), packed(columns.y.differences()),
      packed(columns.heading.differences()), packed(columns.speed.differences()), who, what);
}

double least_step(const std::vector<AnimatedRun>& runs, double rate) {
  double least = std::numeric_limits<double>::infinity();
  for (const AnimatedRun& run : runs) {
    const double step = frames_of(*run.recording, rate).step;
    if (step > 0.0) least = std::min(least, step);
  }
  return std::isfinite(least) ? least : 1.0 / rate;
}

}  // namespace pedzone::animation
