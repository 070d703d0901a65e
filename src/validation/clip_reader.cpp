#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string_view>

#include "core/error.hpp"
#include "core/input_files.hpp"
#include "core/text.hpp"
#include "core/xml.hpp"
#include "validation/clip.hpp"
#include "world/speed_gain.hpp"

namespace pedzone {
namespace {

namespace fs = std::filesystem;

constexpr double kOnFrame = 0.02;            // [s] a time is taken to be that of the nearest frame
constexpr NumberRange kPlaces{-1e6, 1e6};    // [m] of coordinates
constexpr NumberRange kSizes{0.0, 50.0};     // [m] of a vehicle
constexpr NumberRange kHeadings{-6.3, 6.3};  // [rad] once round, either way: no degrees
constexpr double kFastest = 20.0;  // [m/s] numerical: nobody on foot, however roughly measured

enum Column { kT, kKind, kId, kX, kY, kHeading, kFront, kRear, kHalfWidth, kColumns };
constexpr std::array<std::string_view, kColumns> kColumnNames{
    "t", "kind", "id", "x", "y", "heading", "front", "rear", "half_width"};

std::vector<std::string_view> split(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    cells.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

/// One file while it is read.
class ClipFile {
 public:
  explicit ClipFile(const fs::path& path) : name_(path.string()), stream_(path) {
    if (!stream_) throw InputError("cannot be read", {name_, 0, "", "", "a CSV file"});
    note_input(name_);
  }

  Clip read();

 private:
  struct Row {
    int frame = 0;
    std::string_view id;
    Vec2 place = Vec2::Zero();
  };

  [[noreturn]] void fail(const std::string& problem, Column column, std::string_view value,
                         const std::string& allowed) const {
    throw InputError(problem, {name_, line_, "column " + std::string(kColumnNames[column]),
                               std::string(value), allowed});
  }

  void read_header();
  double number(Column column, const NumberRange& range) const;
  Row row() const;
  void add_person(Clip& clip, const Row& row);
  void add_vehicle(Clip& clip, const Row& row);
  template <class Track>
  Track& track(std::vector<Track>& tracks, std::map<std::string, std::size_t, std::less<>>& index,
               const Row& row, std::size_t size_of(const Track&)) const;

  std::string name_;
  std::ifstream stream_;
  int line_ = 0;
  std::string text_;
  std::array<std::size_t, kColumns> where_{};
  std::vector<std::string_view> cells_;
  std::map<std::string, std::size_t, std::less<>> persons_, vehicles_;
};

void ClipFile::read_header() {
  line_ = 1;
  if (!std::getline(stream_, text_)) {
    throw InputError("is empty", {name_, 0, "", "", "a header line and one row a frame and track"});
  }
  text_.erase(0, mark_length(text_));
  const std::vector<std::string_view> header = split(text_);
  for (std::size_t c = 0; c < kColumns; ++c) {
    const auto found = std::find(header.begin(), header.end(), kColumnNames[c]);
    if (found == header.end()) {
      fail("is missing", static_cast<Column>(c), text_,
           "t,kind,id,x,y,heading,front,rear,half_width in any order");
    }
    where_[c] = static_cast<std::size_t>(found - header.begin());
  }
}

double ClipFile::number(Column column, const NumberRange& range) const {
  const std::string_view cell = cells_[where_[column]];
  double value = 0.0;
  if (!parse_number(cell, value)) fail("is not a number", column, cell, "a number");
  if (value < range.least || value > range.most) {
    fail("is out of range", column, cell, describe(range));
  }
  return value;
}

ClipFile::Row ClipFile::row() const {
  Row row;
  const double t = number(kT, {0.0, 1e6});
  row.frame = static_cast<int>(std::lround(t / kFrame));
  if (std::abs(t - row.frame * kFrame) > kOnFrame) {
    fail("is between two frames", kT, cells_[where_[kT]], "multiples of 0.1 s (10 Hz)");
  }
  row.id = cells_[where_[kId]];
  if (row.id.empty()) fail("is empty", kId, row.id, "an id");
  row.place = {number(kX, kPlaces), number(kY, kPlaces)};
  return row;
}

/// The track of the row's id, new or checked to have no gap.
template <class Track>
Track& ClipFile::track(std::vector<Track>& tracks,
                       std::map<std::string, std::size_t, std::less<>>& index, const Row& row,
                       std::size_t size_of(const Track&)) const {
  const auto found = index.find(row.id);
  if (found == index.end()) {
    index.emplace(std::string(row.id), tracks.size());
    Track& added = tracks.emplace_back();
    added.id = std::string(row.id);
    added.first = row.frame;
    return added;
  }
  Track& known = tracks[found->second];
  const int expected = known.first + static_cast<int>(size_of(known));
  if (row.frame < expected) {
    fail("is not later than the row before of id " + std::string(row.id), kT, cells_[where_[kT]],
         "rows of one track in the order of time, and an id of its own for each");
  }
  if (row.frame > expected) {
    fail("leaves a gap in time for id " + std::string(row.id), kT, cells_[where_[kT]],
         std::to_string(expected * kFrame) + " (the rows of one track, 0.1 s apart, in order)");
  }
  return known;
}

void ClipFile::add_person(Clip& clip, const Row& row) {
  PersonTrack& person = track<PersonTrack>(clip.persons, persons_, row,
                                           [](const PersonTrack& t) { return t.places.size(); });
  if (!person.places.empty() && (row.place - person.places.back()).norm() > kFastest * kFrame) {
    fail("is farther from the row before than people get in 0.1 s", kX, cells_[where_[kX]],
         "metres, as of one person");
  }
  person.places.push_back(row.place);
}

void ClipFile::add_vehicle(Clip& clip, const Row& row) {
  VehicleTrack& vehicle = track<VehicleTrack>(
      clip.vehicles, vehicles_, row, [](const VehicleTrack& t) { return t.states.size(); });
  const double front = number(kFront, kSizes), rear = number(kRear, kSizes);
  const double half_width = number(kHalfWidth, kSizes);
  if (!(front + rear > 0.0)) fail("is no size", kFront, cells_[where_[kFront]], "more than 0");
  if (!(half_width > 0.0)) {
    fail("is no size", kHalfWidth, cells_[where_[kHalfWidth]], "more than 0");
  }
  VehicleState state;
  state.heading = number(kHeading, kHeadings);
  state.centre = row.place + 0.5 * (front - rear) * unit(state.heading);
  state.length = front + rear;
  state.width = 2.0 * half_width;
  vehicle.states.push_back(state);
}

/// Velocities, yaw rates and gains of speed as somebody present sees them: from the past, except in
/// the first frame.
void set_velocities(VehicleTrack& vehicle) {
  const int count = static_cast<int>(vehicle.states.size());
  for (int i = 0; i < count; ++i) {
    const int from = std::max(0, i - kPast);
    const int to = i > 0 ? i : std::min(count - 1, kPast);
    if (from == to) continue;
    const VehicleState& a = vehicle.states[static_cast<std::size_t>(from)];
    const VehicleState& b = vehicle.states[static_cast<std::size_t>(to)];
    VehicleState& now = vehicle.states[static_cast<std::size_t>(i)];
    const double time = (to - from) * kFrame;
    now.velocity = (b.centre - a.centre) / time;
    now.yaw_rate = wrap_angle(b.heading - a.heading) / time;
  }
  SpeedGain gain(vehicle.states.front().velocity.norm());
  for (VehicleState& now : vehicle.states) {
    gain.follow(now.velocity.norm(), kFrame);
    now.gain = gain.ahead();
  }
}

Clip ClipFile::read() {
  Clip clip;
  read_header();
  while (std::getline(stream_, text_)) {
    ++line_;
    if (text_.empty() || text_ == "\r") continue;
    cells_ = split(text_);
    if (cells_.size() <= *std::max_element(where_.begin(), where_.end())) {
      throw InputError("is cut off", {name_, line_, "row", text_, "a value in every column"});
    }
    const std::string_view kind = cells_[where_[kKind]];
    if (kind == "ped") {
      add_person(clip, row());
    } else if (kind == "veh") {
      add_vehicle(clip, row());
    } else {
      fail("is unknown", kKind, kind, "ped or veh");
    }
  }
  if (clip.persons.empty()) throw InputError("has no rows of persons", {name_, 0, "", "", "ped"});
  for (VehicleTrack& vehicle : clip.vehicles) set_velocities(vehicle);
  return clip;
}

/// From names such as `bidirection_normal_driving_03`.
std::string manoeuvre_of(const std::string& name) {
  constexpr std::pair<std::string_view, std::string_view> kKnown[] = {
      {"unidirection", "lateral one-way"},
      {"bidirection", "lateral two-way"},
      {"front", "front"},
      {"back", "back"},
      {"intersection", "intersection"},
      {"roundabout", "roundabout"}};
  for (const auto& [start, manoeuvre] : kKnown) {
    if (name.starts_with(start)) return std::string(manoeuvre);
  }
  return name.substr(0, name.find_last_not_of("0123456789_") + 1);
}

std::vector<fs::path> sorted(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    found.push_back(it->path());
  }
  if (error) {
    throw InputError("cannot be read: " + error.message(),
                     {folder.string(), 0, "option --data", folder.string(), "a folder of clips"});
  }
  std::sort(found.begin(), found.end());
  return found;
}

void read_site(const fs::path& folder, std::vector<Clip>& clips) {
  for (const fs::path& path : sorted(folder)) {
    if (path.extension() != ".csv" || !fs::is_regular_file(path)) continue;
    Clip clip = ClipFile(path).read();
    clip.name = path.stem().string();
    clip.site = fs::weakly_canonical(folder).filename().string();
    clip.manoeuvre = manoeuvre_of(clip.name);
    clips.push_back(std::move(clip));
  }
}

}  // namespace

std::vector<Clip> read_clips(const std::string& folder) {
  std::vector<Clip> clips;
  read_site(folder, clips);
  for (const fs::path& path : sorted(folder)) {
    if (fs::is_directory(path)) read_site(path, clips);
  }
  if (clips.empty()) {
    throw InputError("has no clips", {folder, 0, "option --data", folder,
                                      "a folder with CSV files, or with one folder a site"});
  }
  return clips;
}

}  // namespace pedzone
