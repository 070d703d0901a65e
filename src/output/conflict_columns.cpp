#include "output/conflict_columns.hpp"

namespace pedzone {

std::vector<std::string> conflict_columns() {
  std::vector<std::string> columns{"person", "vehicle", "begin", "end", "type", "first", "aware"};
  for (const ConflictMeasure& measure : kConflictMeasures) {
    for (const char* part :
         {"", "_time", "_x", "_y", "_type", "_personSpeed", "_vehicleSpeed", "_relativeSpeed"}) {
      columns.push_back(std::string(measure.name) + part);
    }
  }
  for (const std::string reaction : {"PCT", "TBT", "TMT"}) {
    columns.insert(columns.end(), {reaction, reaction + "_time"});
  }
  return columns;
}

}  // namespace pedzone
