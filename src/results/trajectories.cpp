#include "results/trajectories.hpp"

namespace pedzone {
namespace {

constexpr std::size_t kBuffer = 1 << 20;   // [bytes] numerical: written in pieces of this size
constexpr NumberRange kTimes{-1e9, 1e9};   // [s]
constexpr NumberRange kPlaces{-1e9, 1e9};  // [m]
constexpr NumberRange kSpeeds{-1000.0, 1000.0};  // [m/s]
constexpr NumberRange kAngles{-10.0, 10.0};      // [rad] more than any that is written

void read_motion(TrajectoryRow& row, const CsvRow& fields, std::size_t c) {
  for (const Motion one : {Motion::kWalking, Motion::kWaiting, Motion::kStanding}) {
    if (fields[c] == name_of(one)) {
      row.motion = one;
      return;
    }
  }
  throw fields.error("is no motion", c, "walking, waiting, standing");
}

void read_activity(TrajectoryRow& row, const CsvRow& fields, std::size_t c) {
  const ActivityInfo* info = find_activity(fields[c]);
  if (info == nullptr) {
    throw fields.error("is no activity", c, comma_list(activity_list(), &ActivityInfo::id));
  }
  row.activity = info->activity;
}

}  // namespace

const Table<TrajectoryRow>& trajectory_table() {
  using Row = TrajectoryRow;
  static const Table<Row> table{{
      number_column({"time", "s", "of the simulation"}, &Row::time, 2, kTimes),
      text_column({"id", "", "of the person"}, &Row::id),
      number_column({"x", "m", "of the body's centre, in the network"}, &Row::x, 3, kPlaces),
      number_column({"y", "m", "the same"}, &Row::y, 3, kPlaces),
      number_column({"vx", "m/s", "velocity"}, &Row::vx, 3, kSpeeds),
      number_column({"vy", "m/s", "the same"}, &Row::vy, 3, kSpeeds),
      number_column({"heading", "rad", "where it faces, counter-clockwise from +x"}, &Row::heading,
                    3, kAngles),
      {{"motion", "", "`walking`, `waiting` or `standing`"},
       [](std::string& line, const Row& row) { line += name_of(row.motion); },
       read_motion},
      {{"activity", "", "what it does beside walking: `none`, `texting`, ..."},
       [](std::string& line, const Row& row) { line += info_of(row.activity).id; },
       read_activity},
  }};
  return table;
}

TrajectoryWriter::TrajectoryWriter(const std::string& path, const std::string& option)
    : file_(path, option), buffer_(trajectory_table().header()) {}

void TrajectoryWriter::row(double time, std::string_view id, const PersonView& person) {
  trajectory_table().append(
      buffer_, {time, id, person.position.x(), person.position.y(), person.velocity.x(),
                person.velocity.y(), person.heading, person.motion, person.activity});
  if (buffer_.size() > kBuffer) flush();
}

void TrajectoryWriter::flush() {
  file_.write(buffer_);
  buffer_.clear();
}

void TrajectoryWriter::finish() {
  flush();
  file_.finish();
}

}  // namespace pedzone
