#include "results/trajectories.hpp"

namespace pedzone {
namespace {

constexpr std::size_t kBuffer = 1 << 20;   // [bytes] numerical: written in pieces of this size
constexpr NumberRange kTimes{-1e9, 1e9};   // [s]
constexpr NumberRange kPlaces{-1e9, 1e9};  // [m]
constexpr NumberRange kSpeeds{-1000.0, 1000.0};  // [m/s]
constexpr NumberRange kAngles{-10.0, 10.0};      // [rad] more than any that is written

void read_activity(TrajectoryRow& row, const CsvRow& fields, std::size_t c) {
  for (const Activity one : {Activity::kWalking, Activity::kWaiting, Activity::kStanding}) {
    if (fields[c] == name_of(one)) {
      row.activity = one;
      return;
    }
  }
  throw fields.error("is no activity", c, "walking, waiting, standing");
}

void read_pastime(TrajectoryRow& row, const CsvRow& fields, std::size_t c) {
  const PastimeInfo* info = find_pastime(fields[c]);
  if (info == nullptr) {
    throw fields.error("is no pastime", c, comma_list(pastime_list(), &PastimeInfo::id));
  }
  row.pastime = info->pastime;
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
      {{"activity", "", "`walking`, `waiting` or `standing`"},
       [](std::string& line, const Row& row) { line += name_of(row.activity); },
       read_activity},
      {{"pastime", "", "what it does beside walking: `none`, `texting`, ..."},
       [](std::string& line, const Row& row) { line += info_of(row.pastime).id; },
       read_pastime},
  }};
  return table;
}

TrajectoryWriter::TrajectoryWriter(const std::string& path, const std::string& option)
    : file_(path, option), buffer_(trajectory_table().header()) {}

void TrajectoryWriter::row(double time, std::string_view id, const PersonView& person) {
  trajectory_table().append(
      buffer_, {time, id, person.position.x(), person.position.y(), person.velocity.x(),
                person.velocity.y(), person.heading, person.activity, person.pastime});
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
