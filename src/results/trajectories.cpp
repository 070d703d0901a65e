#include "results/trajectories.hpp"

#include "core/error.hpp"
#include "results/complete_file.hpp"
#include "results/sqlite_trajectories.hpp"
#include "results/text_trajectories.hpp"

namespace pedzone {
namespace {

constexpr NumberRange kTimes{-1e9, 1e9};         // [s]
constexpr NumberRange kPlaces{-1e9, 1e9};        // [m]
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

class TableTrajectories final : public TrajectoryFile {
 public:
  TableTrajectories(const std::string& path, const std::string& option) : file_(path, option) {
    file_.write(trajectory_table().header());
  }
  void begin(const TrajectoryHead&) override {}
  void row(const TrajectoryRow& row) override {
    line_.clear();
    trajectory_table().append(line_, row);
    file_.write(line_);
  }
  void finish() override { file_.finish(); }

 private:
  CompleteFile file_;
  std::string line_;
};

bool is_sqlite(const std::string& path) { return path.ends_with(".sqlite"); }
bool is_text(const std::string& path) {
  return path.ends_with(".txt") || path.ends_with(".txt.gz");
}

/// Where a name asks for what it would not get.
void refuse_other_formats(const std::string& path, const std::string& option) {
  const auto refuse = [&](const std::string& problem) {
    throw InputError(problem,
                     {.element = "option " + option,
                      .value = path,
                      .allowed = "NAME.csv, NAME.txt, NAME.csv.gz, NAME.txt.gz, NAME.sqlite"});
  };
  if (path.ends_with(".sqlite.gz")) refuse("is a database, which cannot be written compressed");
  if (path.ends_with(".parquet")) refuse("is a format that pedzone does not write");
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
      {{"motion", "", "`walking`, `waiting` or `standing`", ColumnKind::kText},
       [](std::string& line, const Row& row) { line += name_of(row.motion); },
       read_motion},
      {{"activity", "", "what it does beside walking: `none`, `texting`, ...", ColumnKind::kText},
       [](std::string& line, const Row& row) { line += info_of(row.activity).id; },
       read_activity},
  }};
  return table;
}

bool TrajectoryWriter::is_table(const std::string& path) {
  return !is_sqlite(path) && !is_text(path);
}

std::string TrajectoryWriter::side_file(const std::string& path) {
  return is_text(path) ? person_ids_file(path) : "";
}

TrajectoryWriter::TrajectoryWriter(const std::string& path, const std::string& option) {
  refuse_other_formats(path, option);
  if (is_sqlite(path)) {
    file_ = make_sqlite_trajectories(path, option);
  } else if (is_text(path)) {
    file_ = make_text_trajectories(path, option);
  } else {
    file_ = std::make_unique<TableTrajectories>(path, option);
  }
}

void TrajectoryWriter::row(double time, std::string_view id, const PersonView& person) {
  row({time, id, person.position.x(), person.position.y(), person.velocity.x(), person.velocity.y(),
       person.heading, person.motion, person.activity});
}

}  // namespace pedzone
