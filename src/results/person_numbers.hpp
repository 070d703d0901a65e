// Persons as whole numbers, for formats that know no other ids.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "results/table.hpp"
#include "results/trajectories.hpp"

namespace pedzone {

/// A person as long as it is there without a gap.
struct NumberedPerson {
  double number = 0.0;  ///< whole, >= 1
  std::string person;   ///< id in SUMO
};
const Table<NumberedPerson>& numbered_person_table();

/// Who was away for a frame or more has another number afterwards: tools such as PedPy take the
/// speed from one row of a number to its next, however far apart.
class PersonNumbers {
 public:
  /// Frames must not descend.
  std::int64_t number(std::string_view person, std::int64_t frame);
  /// By ascending number, from 1 on without gaps.
  const std::vector<NumberedPerson>& all() const { return all_; }

 private:
  struct Stay {
    std::int64_t number = 0, frame = 0;  ///< frame: the latest
  };
  std::unordered_map<std::string, Stay> stays_;
  std::vector<NumberedPerson> all_;
};

/// The number of the frame at `time` [s]; 0 is the first.
inline std::int64_t frame_at(const TrajectoryHead& head, double time) {
  return std::llround((time - head.begin) / head.step);
}

}  // namespace pedzone
