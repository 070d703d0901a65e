#include "results/sqlite_trajectories.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "results/complete_file.hpp"
#include "results/person_numbers.hpp"

namespace pedzone {
namespace {

constexpr int kVersion = 2;   // of JuPedSim's schema
constexpr int kGeometry = 1;  // JuPedSim: a hash; any number, since there is one geometry

// Kept from JuPedSim's writer (jupedsim/sqlite_serialization.py), to the letter where tools look.
constexpr const char* kSchema =
    "CREATE TABLE trajectory_data (frame INTEGER NOT NULL, id INTEGER NOT NULL,"
    " pos_x REAL NOT NULL, pos_y REAL NOT NULL, ori_x REAL NOT NULL, ori_y REAL NOT NULL);"
    "CREATE TABLE metadata(key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL);"
    "CREATE TABLE geometry(hash INTEGER NOT NULL, wkt TEXT NOT NULL);"
    "CREATE TABLE frame_data(frame INTEGER NOT NULL, geometry_hash INTEGER NOT NULL);"
    "CREATE TABLE person_ids(id INTEGER NOT NULL PRIMARY KEY, person TEXT NOT NULL);";

void append_ring(std::string& text, const Ring& ring) {
  text += '(';
  for (const Vec2& point : ring) {
    fmt::format_to(std::back_inserter(text), "{:.3f} {:.3f}, ", point.x(), point.y());
  }
  fmt::format_to(std::back_inserter(text), "{:.3f} {:.3f})", ring.front().x(), ring.front().y());
}

/// As JuPedSim tells its geometry. Regions lie on a grid of millimetres.
std::string wkt(const Region& region) {
  if (region.empty()) return "GEOMETRYCOLLECTION EMPTY";
  std::string text = "GEOMETRYCOLLECTION (";
  const char* comma = "";
  for (const Polygon& polygon : region) {
    text += std::exchange(comma, ", ");
    text += "POLYGON (";
    append_ring(text, polygon.outer);
    for (const Ring& hole : polygon.holes) {
      text += ", ";
      append_ring(text, hole);
    }
    text += ')';
  }
  return text + ')';
}

/// Executes an insertion with these values.
template <class... Values>
void put(SQLite::Statement& insert, const Values&... values) {
  SQLite::bind(insert, values...);
  insert.exec();
  insert.reset();
}

class SqliteTrajectories final : public TrajectoryFile {
 public:
  SqliteTrajectories(const std::string& path, const std::string& option);
  void begin(const TrajectoryHead& head) override;
  void row(const TrajectoryRow& row) override;
  void finish() override;

 private:
  /// Says of which file a failure is.
  template <class Work>
  void told(const Work& work) const;
  void put_metadata(const std::string& key, const std::string& value);
  void put_extent();

  std::string path_;
  PendingFile pending_;
  std::optional<SQLite::Database> database_;
  std::optional<SQLite::Statement> insert_;
  TrajectoryHead head_;
  PersonNumbers numbers_;
  std::int64_t frames_ = 0;
  Eigen::AlignedBox2d extent_;  ///< [m] of all rows
};

template <class Work>
void SqliteTrajectories::told(const Work& work) const {
  try {
    work();
  } catch (const SQLite::Exception& error) {
    throw std::runtime_error("cannot write " + path_ + ": " + error.what());
  }
}

SqliteTrajectories::SqliteTrajectories(const std::string& path, const std::string& option)
    : path_(path), pending_(path, option) {
  told([this] {
    database_.emplace(pending_.name(), SQLite::OPEN_READWRITE);
    // An unfinished file is thrown away: nothing has to be undone in it.
    database_->exec("PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; BEGIN");
    database_->exec(kSchema);
    insert_.emplace(*database_, "INSERT INTO trajectory_data VALUES(?, ?, ?, ?, ?, ?)");
  });
}

void SqliteTrajectories::put_metadata(const std::string& key, const std::string& value) {
  SQLite::Statement insert(*database_, "INSERT INTO metadata VALUES(?, ?)");
  put(insert, key, value);
}

void SqliteTrajectories::begin(const TrajectoryHead& head) {
  head_ = head;
  told([&] {
    put_metadata("version", std::to_string(kVersion));
    put_metadata("fps", fmt::format("{}", 1.0 / head.step));
    put_metadata("begin", fmt::format("{}", head.begin));
    SQLite::Statement insert(*database_, "INSERT INTO geometry VALUES(?, ?)");
    put(insert, kGeometry, wkt(head.ground));
  });
}

void SqliteTrajectories::row(const TrajectoryRow& row) {
  const std::int64_t frame = frame_at(head_, row.time);
  told([&] {
    put(*insert_, frame, numbers_.number(row.id, frame), row.x, row.y, std::cos(row.heading),
        std::sin(row.heading));
  });
  frames_ = frame + 1;
  extent_.extend(Vec2(row.x, row.y));
}

void SqliteTrajectories::put_extent() {
  if (extent_.isEmpty()) return;
  put_metadata("xmin", fmt::format("{}", extent_.min().x()));
  put_metadata("xmax", fmt::format("{}", extent_.max().x()));
  put_metadata("ymin", fmt::format("{}", extent_.min().y()));
  put_metadata("ymax", fmt::format("{}", extent_.max().y()));
}

void SqliteTrajectories::finish() {
  told([this] {
    SQLite::Statement person(*database_, "INSERT INTO person_ids VALUES(?, ?)");
    for (const NumberedPerson& one : numbers_.all()) {
      put(person, static_cast<std::int64_t>(one.number), one.person);
    }
    SQLite::Statement geometry(*database_, "INSERT INTO frame_data VALUES(?, ?)");
    for (std::int64_t frame = 0; frame < frames_; ++frame) put(geometry, frame, kGeometry);
    put_extent();
    database_->exec("CREATE INDEX frame_id_idx ON trajectory_data(frame, id); COMMIT");
    insert_.reset();
  });
  database_.reset();
  pending_.finish();
}

}  // namespace

std::unique_ptr<TrajectoryFile> make_sqlite_trajectories(const std::string& path,
                                                         const std::string& option) {
  return std::make_unique<SqliteTrajectories>(path, option);
}

}  // namespace pedzone
