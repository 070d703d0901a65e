// Trajectories: where each person is in each step, as a table or in the formats of others.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "crowd/crowd.hpp"
#include "geometry/polygon.hpp"
#include "results/table.hpp"

namespace pedzone {

/// A person in one step.
struct TrajectoryRow {
  double time = 0.0;          ///< [s]
  std::string_view id;        ///< of the person; lives as long as what it was read from
  double x = 0.0, y = 0.0;    ///< [m] network frame
  double vx = 0.0, vy = 0.0;  ///< [m/s]
  double heading = 0.0;       ///< [rad] counter-clockwise from +x
  Motion motion = Motion::kWalking;
  Activity activity = Activity::kNone;
};

const Table<TrajectoryRow>& trajectory_table();

/// What formats have to know that count frames and hold the place.
struct TrajectoryHead {
  double begin = 0.0;  ///< [s] of the first frame
  double step = 0.1;   ///< [s] > 0 between two frames
  Region ground;       ///< [m] where people can be
};

/// Trajectories in one of the formats.
class TrajectoryFile {
 public:
  virtual ~TrajectoryFile() = default;
  /// Before the first row.
  virtual void begin(const TrajectoryHead& head) = 0;
  /// Rows come in the order of time.
  virtual void row(const TrajectoryRow& row) = 0;
  virtual void finish() = 0;
};

/// Writes trajectories in the format that the file's name asks for: NAME.sqlite is JuPedSim's
/// (sqlite_trajectories.hpp), NAME.txt PedPy's (text_trajectories.hpp), all else the table.
class TrajectoryWriter {
 public:
  /// Throws InputError as CompleteFile, and for NAME.parquet and NAME.sqlite.gz.
  TrajectoryWriter(const std::string& path, const std::string& option);
  /// Before the first row; the table does without.
  void begin(const TrajectoryHead& head) { file_->begin(head); }
  /// Rows come in the order of time.
  void row(const TrajectoryRow& row) { file_->row(row); }
  void row(double time, std::string_view id, const PersonView& person);
  void finish() { file_->finish(); }

  /// Whether such a file is the table.
  static bool is_table(const std::string& path);
  /// The file that is written beside it; empty: none.
  static std::string side_file(const std::string& path);

 private:
  std::unique_ptr<TrajectoryFile> file_;
};

}  // namespace pedzone
