// Maps of one run as a page: how crowded, how fast, where people went, where it was close.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "conflict/conflict.hpp"
#include "results/place.hpp"
#include "results/recording.hpp"
#include "view/run_grids.hpp"

namespace pedzone {

/// A point of a fundamental diagram.
struct DiagramPoint {
  double density, speed;  ///< [persons/m²], [m/s]
};

/// How grave a conflict is.
enum class Severity { kSlight, kSerious, kContact };
struct MappedConflict {
  Vec2 at;  ///< [m]
  Severity severity;
  std::string title;  ///< who met whom
};

struct MapsPage {
  std::string title, question;
  std::vector<std::pair<std::string, std::string>> numbers;  ///< name and value
  std::string note;
  const Recording* recording = nullptr;
  const Place* place = nullptr;  ///< null: not known
  Box box;                       ///< [m] what the maps show
  const RunGrids* grids = nullptr;
  bool conflicts_known = false;
  std::vector<MappedConflict> conflicts;
  Box area = {};  ///< [m] that was measured; empty: none
  std::vector<DiagramPoint> diagram;
};

/// The page. The same colours as the maps of a study's report.
std::string maps_page(const MapsPage& page);

}  // namespace pedzone
